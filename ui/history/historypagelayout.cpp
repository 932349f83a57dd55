// What the history page is made of; how it behaves stands in historypage.cpp.

#include "ui/history/checklist.h"
#include "ui/history/daycalendar.h"
#include "ui/history/gapmodel.h"
#include "ui/history/historypage.h"
#include "ui/models/journalmodel.h"
#include "ui/models/statetext.h"
#include "ui/pages/roworder.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedLayout>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace gorizont {

HistoryPage::HistoryPage(const SensorRegistry &registry, const QString &siteName, QWidget *parent)
    : QWidget(parent)
    , m_registry(registry)
    , m_siteName(siteName)
    , m_stack(new QStackedLayout(this))
    , m_sensors(new CheckList(QStringLiteral("historySensors"), tr("All sensors"), this))
    , m_calendar(new DayCalendar(this))
    , m_range(new QLabel(this))
    , m_trouble(new QLabel(this))
    , m_lists(new QTabWidget(this))
    , m_gaps(new GapModel(this))
    , m_gapTable(new TableView(QStringLiteral("gapTable"), this))
    , m_journal(std::make_unique<Journal>())
    , m_events(new JournalFilter(this))
    , m_eventTable(new TableView(QStringLiteral("dayEventTable"), this))
    , m_export(new QPushButton(tr("&Export…"), this))
{
    setObjectName(QStringLiteral("historyPage"));
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        m_sensors->add(statetext::sensorTitle(sensor.config), sensor.config.number);
    }
    auto *nothing = new QLabel(
        tr("There is no archive. Switch it on in the section [Archive] of GorizontServer.ini and start the program "
           "again."),
        this);
    nothing->setObjectName(QStringLiteral("noArchive"));
    nothing->setWordWrap(true);
    nothing->setAlignment(Qt::AlignCenter);
    auto *columns = new QSplitter(this);
    auto *rows = new QSplitter(Qt::Vertical, columns);
    columns->setObjectName(QStringLiteral("historyColumns"));
    rows->setObjectName(QStringLiteral("historyRows"));
    columns->addWidget(m_sensors);
    columns->addWidget(rows);
    columns->setStretchFactor(1, 1);
    columns->setChildrenCollapsible(false);
    rows->addWidget(makeDays());
    rows->addWidget(makeLists());
    rows->setStretchFactor(1, 1);
    rows->setChildrenCollapsible(false);
    m_stack->addWidget(nothing);
    m_stack->addWidget(columns);
    setFocusProxy(m_calendar);

    m_again.setInterval(std::chrono::minutes(1));
    connect(&m_again, &QTimer::timeout, this, &HistoryPage::refresh);
    connect(m_sensors, &CheckList::changed, this, &HistoryPage::refresh);
    connect(m_calendar, &DayCalendar::shown, this, &HistoryPage::askMonths);
    connect(m_calendar, &DayCalendar::chosen, this, &HistoryPage::askDays);
    connect(&m_monthsAnswer, &QFutureWatcherBase::finished, this, &HistoryPage::takeMonths);
    connect(&m_gapsAnswer, &QFutureWatcherBase::finished, this, &HistoryPage::takeGaps);
    connect(&m_eventsAnswer, &QFutureWatcherBase::finished, this, &HistoryPage::takeEvents);
    connect(m_export, &QPushButton::clicked, this, &HistoryPage::openExport);
}

/// The calendar between its buttons.
QWidget *HistoryPage::makeDays()
{
    m_calendar->setObjectName(QStringLiteral("dayCalendar"));
    m_trouble->setObjectName(QStringLiteral("historyTrouble"));
    auto *days = new QWidget(this);
    const auto button = [days](Qt::ArrowType arrow, const QString &title, const char *name) {
        auto *one = new QToolButton(days);
        one->setArrowType(arrow);
        one->setToolTip(title);
        one->setAccessibleName(title);
        one->setObjectName(QLatin1String(name));
        return one;
    };
    QToolButton *earlier = button(Qt::LeftArrow, tr("Earlier months"), "earlierButton");
    QToolButton *later = button(Qt::RightArrow, tr("Later months"), "laterButton");
    connect(earlier, &QToolButton::clicked, m_calendar, &DayCalendar::showEarlier);
    connect(later, &QToolButton::clicked, m_calendar, &DayCalendar::showLater);
    auto *scroll = new QScrollArea(days); // of a low window
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_calendar);
    connect(m_calendar, &DayCalendar::chosen, this, [this, scroll] {
        const QRect day = m_calendar->currentRect();
        scroll->ensureVisible(day.center().x(), day.center().y(), day.width() / 2, day.height() / 2);
    });
    auto *bar = new QHBoxLayout;
    bar->addWidget(earlier);
    bar->addWidget(later);
    bar->addWidget(m_trouble, 1);
    auto *layout = new QVBoxLayout(days);
    layout->setContentsMargins(TableColumns::sideMargin, 4, TableColumns::sideMargin, 4);
    layout->addLayout(bar);
    layout->addWidget(scroll, 1);
    return days;
}

/// What there is about the chosen days.
QWidget *HistoryPage::makeLists()
{
    m_range->setObjectName(QStringLiteral("historyRange"));
    m_export->setObjectName(QStringLiteral("exportButton"));
    m_lists->setObjectName(QStringLiteral("historyLists"));
    m_lists->setDocumentMode(true);
    m_gapTable->setModel(new RowOrder(m_gaps, GapModel::SortRole, this));
    m_eventTable->setModel(m_events);
    m_eventTable->setAlternatingRowColors(false);
    m_eventTable->horizontalHeader()->hide();
    m_eventTable->horizontalHeader()->setStretchLastSection(true);
    m_lists->addTab(m_gapTable, QString());
    m_lists->addTab(m_eventTable, QString());
    setColumns();
    auto *lists = new QWidget(this);
    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(TableColumns::sideMargin, 0, TableColumns::sideMargin, 0);
    bar->addWidget(m_range, 1);
    bar->addWidget(m_export);
    auto *layout = new QVBoxLayout(lists);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(bar);
    layout->addWidget(m_lists, 1);
    return lists;
}

void HistoryPage::setColumns()
{
    m_gapTable->horizontalHeader()->setSectionsMovable(true);
    TableColumns &columns = m_gapTable->columns();
    columns.setDefaultSort(GapModel::From);
    columns.setSample(GapModel::Sensor, QString(20, u'n'));
    columns.setSample(GapModel::From, QStringLiteral("00:00:00 00.00.00"));
    columns.setSample(GapModel::To, QStringLiteral("00:00:00 00.00.00"));
    columns.setSample(GapModel::Length, QStringLiteral("10000:00:00"));
    columns.setSample(GapModel::FilledFrom, QString(10, u'n'));
    columns.setElastic(GapModel::Reason, QString(20, u'n'));
}

} // namespace gorizont
