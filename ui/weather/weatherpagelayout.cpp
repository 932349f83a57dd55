// What the page of the weather is made of; how it behaves stands in weatherpage.cpp.

#include "ui/models/propertymodel.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"
#include "ui/weather/inputlamps.h"
#include "ui/weather/precipitationmodel.h"
#include "ui/weather/stationfilesmodel.h"
#include "ui/weather/weathermodel.h"
#include "ui/weather/weatherpage.h"
#include "ui/weather/windroseview.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>

namespace gorizont {

namespace {

void setParameterColumns(TableColumns &columns)
{
    columns.setElastic(WeatherModel::Name, QString(20, u'n'));
    columns.setSample(WeatherModel::Code, QStringLiteral("M10"));
    columns.setSample(WeatherModel::Unit, QStringLiteral("мм рт. ст."));
    for (int column = WeatherModel::Mean; column < WeatherModel::ColumnCount; ++column) {
        columns.setSample(column, QStringLiteral("-1000.00"));
    }
}

void setRainColumns(TableColumns &columns)
{
    columns.setSample(PrecipitationModel::Begin, QStringLiteral("28.11.2026 23:59:59"));
    columns.setSample(PrecipitationModel::End, QStringLiteral("28.11.2026 23:59:59"));
    columns.setElastic(PrecipitationModel::Duration, QStringLiteral("10:00:00"));
}

void setFileColumns(TableColumns &columns)
{
    columns.setSample(StationFilesModel::File, QStringLiteral("CORRECT.M10"));
    columns.setSample(StationFilesModel::Line, QStringLiteral("1000"));
    columns.setSample(StationFilesModel::Field, QString(20, u'n'));
    columns.setElastic(StationFilesModel::Problem, QString(40, u'n'));
    columns.setSample(StationFilesModel::Action, QString(30, u'n'));
}

QLabel *heading(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    label->setContentsMargins(TableColumns::sideMargin, 0, TableColumns::sideMargin, 0);
    return label;
}

QSplitter *makeSplitter(Qt::Orientation orientation, const QString &name, QWidget *parent)
{
    auto *splitter = new QSplitter(orientation, parent);
    splitter->setObjectName(name);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

} // namespace

QWidget *WeatherPage::makeBar()
{
    auto *bar = new QWidget(this);
    auto *layout = new QHBoxLayout(bar);
    const int margin = TableColumns::sideMargin;
    layout->setContentsMargins(margin, margin, margin, margin);
    m_stations->setObjectName(QStringLiteral("stationBox"));
    m_stations->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_stations->setMinimumContentsLength(22);
    m_stations->setAccessibleName(tr("Weather station"));
    m_spans->setObjectName(QStringLiteral("windSpan"));
    m_spans->setAccessibleName(tr("Time over which the winds are gathered"));
    m_spans->setToolTip(m_spans->accessibleName());
    m_spans->addItem(tr("10 minutes"), 10);
    m_spans->addItem(tr("1 hour"), 60);
    m_spans->addItem(tr("6 hours"), 360);
    m_spans->addItem(tr("24 hours"), 1440);
    m_spans->setCurrentIndex(1);
    m_status->setObjectName(QStringLiteral("weatherStatus"));
    m_status->setWordWrap(true); // a sentence must not widen the window
    m_age->setObjectName(QStringLiteral("weatherAge"));
    for (QLabel *label : {m_status, m_age, m_inputs}) {
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto *span = new QLabel(tr("&Rose over:"), bar);
    span->setBuddy(m_spans);
    layout->addWidget(m_stations);
    layout->addWidget(m_status, 1);
    layout->addWidget(m_age);
    layout->addWidget(span);
    layout->addWidget(m_spans);
    return bar;
}

/// The wind as numbers, the inputs, the rain: from top to bottom.
QWidget *WeatherPage::makeNumbers()
{
    auto *side = makeSplitter(Qt::Vertical, QStringLiteral("weatherSide"), this);
    m_windTable->setModel(m_wind);
    connect(m_wind, &PropertyModel::modelReset, m_windTable, [this] {
        m_windTable->clearSpans();
        for (int row = 0; row < m_wind->rowCount(); ++row) {
            if (m_wind->properties().at(row).isSection) {
                m_windTable->setSpan(row, 0, 1, m_wind->columnCount());
            }
        }
    });
    m_windTable->setAccessibleName(tr("The wind as numbers"));
    m_windTable->columns().setSample(PropertyModel::Name, QString(28, u'n'));
    m_windTable->columns().setElastic(PropertyModel::Value, QStringLiteral("359° ЗСЗ"));
    auto *lower = new QWidget(side);
    auto *layout = new QVBoxLayout(lower);
    layout->setContentsMargins(0, TableColumns::sideMargin, 0, 0);
    m_inputs->setObjectName(QStringLiteral("inputWord"));
    auto *inputsHeading = new QHBoxLayout;
    inputsHeading->addWidget(heading(tr("Digital inputs"), lower));
    inputsHeading->addWidget(m_inputs, 1);
    auto *lamps = new QHBoxLayout;
    lamps->setContentsMargins(TableColumns::sideMargin, 0, TableColumns::sideMargin, 0);
    lamps->addWidget(m_lamps);
    lamps->addStretch(1);
    m_rainTable->setModel(m_rain);
    m_rainTable->setAccessibleName(tr("Precipitation"));
    m_rainTable->setEmptyText(tr("No precipitation is known. Only command 8 brings it."));
    setRainColumns(m_rainTable->columns());
    layout->addLayout(inputsHeading);
    layout->addLayout(lamps);
    layout->addWidget(m_rainTable, 1);
    side->addWidget(m_windTable);
    side->addWidget(lower);
    side->setStretchFactor(0, 3);
    side->setStretchFactor(1, 2);
    return side;
}

void WeatherPage::build()
{
    setFocusProxy(m_table);
    m_table->setModel(m_parameters);
    m_table->setAccessibleName(tr("Parameters of the weather station"));
    setParameterColumns(m_table->columns());
    QSplitter *upper = makeSplitter(Qt::Horizontal, QStringLiteral("weatherColumns"), this);
    upper->addWidget(m_rose);
    upper->addWidget(makeNumbers());
    upper->setStretchFactor(0, 1);
    upper->setStretchFactor(1, 1);
    QSplitter *rows = makeSplitter(Qt::Vertical, QStringLiteral("weatherRows"), this);
    rows->addWidget(upper);
    rows->addWidget(m_table);
    m_filesTable->setModel(m_files);
    m_filesTable->setAccessibleName(tr("Errors in the files of the station"));
    setFileColumns(m_filesTable->columns());
    m_filesTable->hide();
    rows->addWidget(m_filesTable);
    rows->setStretchFactor(0, 3);
    rows->setStretchFactor(1, 2);
    rows->setStretchFactor(2, 1);
    rows->setSizes({460, 9 * m_table->verticalHeader()->defaultSectionSize(), 120});
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeBar());
    layout->addWidget(rows, 1);
}

} // namespace gorizont
