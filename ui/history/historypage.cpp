// How the history page behaves; what it is made of stands in historypagelayout.cpp.

#include "ui/history/historypage.h"

#include "ui/history/checklist.h"
#include "ui/history/daycalendar.h"
#include "ui/history/exportdialog.h"
#include "ui/history/gapmodel.h"
#include "ui/models/journalmodel.h"
#include "ui/pages/tableview.h"

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStackedLayout>
#include <QTabWidget>

namespace gorizont {

namespace {

enum List { Gaps, Events };

constexpr int mostEvents = 5000;

UtcTime beginOf(QDate day)
{
    return UtcTime(std::chrono::milliseconds(day.startOfDay().toMSecsSinceEpoch()));
}

/// Whatever was asked before is forgotten.
template <typename T> void ask(QFutureWatcher<T> &watcher, const QFuture<T> &question)
{
    watcher.cancel();
    watcher.setFuture(question);
}

template <typename T> bool hasAnswer(const QFutureWatcher<T> &watcher)
{
    return !watcher.isCanceled() && watcher.future().resultCount() > 0;
}

} // namespace

void HistoryPage::setSource(const ArchiveSource &source)
{
    m_source = source;
    m_stack->setCurrentIndex(source.completeness ? 1 : 0);
    if (isVisible()) {
        refresh();
    }
}

void HistoryPage::show(int number, QDate first, QDate last)
{
    m_sensors->setChosen({number});
    m_calendar->choose(first, last);
    refresh();
}

void HistoryPage::refresh()
{
    m_calendar->setToday(QDate::currentDate());
    askMonths();
    askDays();
    if (isVisible()) {
        m_again.start();
    }
}

void HistoryPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

void HistoryPage::hideEvent(QHideEvent *event)
{
    m_again.stop();
    QWidget::hideEvent(event);
}

QList<SensorConfig> HistoryPage::sensors() const
{
    QList<SensorConfig> configs;
    for (const SensorRegistry::Sensor &sensor : m_registry.sensors()) {
        configs << sensor.config;
    }
    return configs;
}

void HistoryPage::askMonths()
{
    if (m_source.completeness) {
        ask(m_monthsAnswer,
            m_source.completeness(m_sensors->chosen(), m_calendar->firstShown(), m_calendar->lastShown()));
    }
}

void HistoryPage::askDays()
{
    const QDate first = m_calendar->firstChosen();
    const QDate last = m_calendar->lastChosen();
    const QString begin = calendarLocale().toString(first, QLocale::LongFormat);
    m_range->setText(
        first == last ? begin : tr("%1 to %2").arg(begin, calendarLocale().toString(last, QLocale::LongFormat)));
    const QList<int> numbers = m_sensors->chosen();
    m_export->setEnabled(!numbers.isEmpty());
    const UtcTime from = beginOf(first);
    const UtcTime to = beginOf(last.addDays(1));
    if (m_source.gaps) {
        say(m_gapTable, Gaps, tr("Gaps"), tr("Looking for gaps…"));
        ask(m_gapsAnswer, m_source.gaps(numbers, from, to));
    }
    if (m_source.events) {
        say(m_eventTable, Events, tr("Events"), tr("Looking for events…"));
        ask(m_eventsAnswer, m_source.events(from, to, mostEvents));
    }
}

void HistoryPage::say(TableView *table, int tab, const QString &title, const QString &emptyText)
{
    m_lists->setTabText(tab, title);
    table->setEmptyText(emptyText);
}

void HistoryPage::takeMonths()
{
    m_trouble->setText(hasAnswer(m_monthsAnswer) ? QString() : tr("The archive does not answer; F5 asks again."));
    m_calendar->setMarks(hasAnswer(m_monthsAnswer) ? dayMarks(m_monthsAnswer.result(), sensors()) : DayMarks());
}

void HistoryPage::takeGaps()
{
    const QList<Gap> gaps = hasAnswer(m_gapsAnswer) ? m_gapsAnswer.result() : QList<Gap>();
    m_gaps->setSensors(sensors());
    m_gaps->setGaps(gaps, utcNow());
    say(m_gapTable, Gaps, gaps.isEmpty() ? tr("Gaps") : tr("Gaps (%1)").arg(gaps.size()),
        m_sensors->chosen().isEmpty() ? tr("Choose a sensor on the left.")
            : hasAnswer(m_gapsAnswer) ? tr("Nothing is missing in these days.")
                                      : tr("The archive does not answer; F5 asks again."));
}

void HistoryPage::takeEvents()
{
    const QList<JournalEntry> events = hasAnswer(m_eventsAnswer) ? m_eventsAnswer.result() : QList<JournalEntry>();
    auto journal = std::make_unique<Journal>();
    for (const JournalEntry &event : events) {
        journal->append(event);
    }
    delete m_events->sourceModel();
    m_events->setSourceModel(new JournalModel(*journal, m_events));
    m_journal = std::move(journal);
    const QString title = events.size() >= mostEvents ? tr("Events (the last %1)") : tr("Events (%1)");
    say(m_eventTable, Events, events.isEmpty() ? tr("Events") : title.arg(events.size()),
        hasAnswer(m_eventsAnswer) ? tr("No events in these days.") : tr("The archive does not answer; F5 asks again."));
}

void HistoryPage::openExport()
{
    ExportForm::Start start;
    start.sensors = sensors();
    start.chosen = m_sensors->chosen();
    start.first = m_calendar->firstChosen();
    start.last = m_calendar->lastChosen();
    start.station = seedStation(m_siteName);
    auto *dialog = new ExportDialog(m_source, start, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace gorizont
