#pragma once

#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"
#include "core/values/archivesource.h"

#include <QFutureWatcher>
#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;
class QStackedLayout;
class QTabWidget;

namespace gorizont {

class CheckList;
class DayCalendar;
class GapModel;
class JournalFilter;
class TableView;

/// The page <История>: the days of the chosen sensors by completeness, the gaps and events of the chosen days, and the
/// export. It asks and goes on; an answer that comes after the next question is not shown. GUI thread.
class HistoryPage : public QWidget
{
    Q_OBJECT

public:
    /// \a siteName: what miniSEED calls the station, unless somebody types another code.
    HistoryPage(const SensorRegistry &registry, const QString &siteName, QWidget *parent = nullptr);

    /// From now on \a source is asked; without completeness there is no archive, and the page says so.
    void setSource(const ArchiveSource &source);

    /// Asks again for everything that is shown; once a minute it does so itself while it is visible. The sentences of
    /// the page promise it to F5, which belongs to the window.
    void refresh();

    /// Goes to one sensor and the days of a range.
    void show(int number, QDate first, QDate last);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *makeDays();
    QWidget *makeLists();
    void setColumns();
    QList<SensorConfig> sensors() const;

    void askMonths();
    void askDays();
    void takeMonths();
    void takeGaps();
    void takeEvents();
    void say(TableView *table, int tab, const QString &title, const QString &emptyText);
    void openExport();

    const SensorRegistry &m_registry;
    const QString m_siteName;
    ArchiveSource m_source;
    QStackedLayout *m_stack; ///< the page, or the sentence that there is no archive
    CheckList *m_sensors;
    DayCalendar *m_calendar;
    QLabel *m_range;
    QLabel *m_trouble;
    QTabWidget *m_lists;
    GapModel *m_gaps;
    TableView *m_gapTable;
    std::unique_ptr<Journal> m_journal; ///< the events of the chosen days
    JournalFilter *m_events;
    TableView *m_eventTable;
    QPushButton *m_export;
    QTimer m_again; ///< a minute after the last question
    QFutureWatcher<QList<DayCompleteness>> m_monthsAnswer;
    QFutureWatcher<QList<Gap>> m_gapsAnswer;
    QFutureWatcher<QList<JournalEntry>> m_eventsAnswer;
};

} // namespace gorizont
