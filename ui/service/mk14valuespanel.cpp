#include "ui/service/mk14valuespanel.h"

#include "ui/models/valuetext.h"
#include "ui/models/weathertext.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"
#include "ui/weather/precipitationmodel.h"
#include "ui/weather/weathermodel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace gorizont {

namespace {

constexpr int rowsInSight = 7;
constexpr int rainInSight = 3;

void fitRows(TableView &table, int rows)
{
    table.setMinimumHeight((rows + 1) * (table.fontMetrics().height() + 8));
}

} // namespace

Mk14ValuesPanel::Mk14ValuesPanel(QWidget *parent)
    : QWidget(parent)
    , m_commands(new QComboBox(this))
    , m_read(new QPushButton(tr("&Read now"), this))
    , m_model(new WeatherModel(this))
    , m_table(new TableView(QStringLiteral("mk14Values"), this))
    , m_inputs(new QLabel(this))
    , m_rain(new PrecipitationModel(this))
    , m_rainTable(new TableView(QStringLiteral("mk14Rain"), this))
{
    m_commands->setObjectName(QStringLiteral("dataCommand"));
    const QStringList brought{
        tr("mean values"),
        tr("mean, instantaneous"),
        tr("mean, minimum, maximum"),
        tr("mean, instantaneous, minimum, maximum"),
        tr("the same and mean voltages"),
        tr("the same and instantaneous voltages"),
        tr("mean, maximum since the last request, σ"),
        tr("mean, σ and maximum of the wind, precipitation")};
    for (int command = 1; command <= brought.size(); ++command) {
        m_commands->addItem(QStringLiteral("%1: %2").arg(command).arg(brought.at(command - 1)), command);
    }
    m_read->setObjectName(QStringLiteral("readNow"));
    m_read->setAutoDefault(false);
    m_read->setToolTip(tr("Commands 7 and 8 make the station begin a new maximum."));
    m_inputs->setObjectName(QStringLiteral("mk14Inputs"));
    m_inputs->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Values of the station"));
    m_table->columns().setElastic(WeatherModel::Name, QString(20, u'n'));
    m_table->columns().setSample(WeatherModel::Code, QStringLiteral("M10"));
    m_table->columns().setSample(WeatherModel::Unit, QStringLiteral("мм рт. ст."));
    for (int column = WeatherModel::Mean; column < WeatherModel::ColumnCount; ++column) {
        m_table->columns().setSample(column, QStringLiteral("-1000.00"));
    }
    fitRows(*m_table, rowsInSight);
    m_table->setMinimumWidth(100 * m_table->fontMetrics().averageCharWidth());
    m_rainTable->setModel(m_rain);
    m_rainTable->setAccessibleName(tr("Precipitation"));
    m_rainTable->setEmptyText(tr("No precipitation. Only command 8 brings it."));
    m_rainTable->columns().setSample(PrecipitationModel::Begin, QStringLiteral("28.11.2026 23:59:59"));
    m_rainTable->columns().setSample(PrecipitationModel::End, QStringLiteral("28.11.2026 23:59:59"));
    m_rainTable->columns().setElastic(PrecipitationModel::Duration, QStringLiteral("100:00:00"));
    fitRows(*m_rainTable, rainInSight);
    auto *label = new QLabel(tr("Data &command:"), this);
    label->setBuddy(m_commands);
    auto *grid = new QGridLayout(this);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_commands, 0, 1);
    grid->addWidget(m_read, 0, 2);
    grid->addWidget(m_table, 1, 0, 1, 3);
    grid->addWidget(new QLabel(tr("Digital inputs:"), this), 2, 0);
    grid->addWidget(m_inputs, 2, 1, 1, 2);
    grid->addWidget(m_rainTable, 3, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(1, 3);
    grid->setRowStretch(3, 1);
    connect(m_read, &QPushButton::clicked, this, &Mk14ValuesPanel::readWanted);
    clear();
}

QWidgetList Mk14ValuesPanel::tabOrder() const
{
    return {m_commands, m_read, m_table, m_rainTable};
}

int Mk14ValuesPanel::command() const
{
    return m_commands->currentData().toInt();
}

void Mk14ValuesPanel::showWeather(const Weather &weather, precipitation::StationClock clock, qint64 now)
{
    m_model->setParameters(weather.parameters, true);
    m_table->setEmptyText(tr("The station has no data yet."));
    m_inputs->setText(weathertext::digital(weather.digital));
    m_rain->setSpells(precipitation::spells(weather.events), clock);
    m_rain->setNow(now);
}

void Mk14ValuesPanel::clear()
{
    m_model->setParameters({}, false);
    m_table->setEmptyText(tr("Nothing has been read."));
    m_inputs->setText(valuetext::absent());
    m_rain->setSpells({}, precipitation::StationClock::Local);
}

void Mk14ValuesPanel::setMayRead(bool mayRead)
{
    m_commands->setEnabled(mayRead);
    m_read->setEnabled(mayRead);
}

} // namespace gorizont
