#pragma once

#include "core/alarms/alarmboard.h"
#include "core/alarms/noticepace.h"
#include "core/registry/sensorregistry.h"
#include "core/values/journalentry.h"

#include <QObject>

class QTimer;

namespace gorizont {

/// Watches the registry for what the dispatcher has to know. The engine has written each change into the journal
/// already; only what the dispatcher does about it is added here. Main thread.
class AlarmWatch : public QObject
{
    Q_OBJECT

public:
    /// What stands in \a registry by now counts as entered now. The registry outlives the watch.
    explicit AlarmWatch(
        const SensorRegistry &registry, const NoticePace::Limits &limits = {}, QObject *parent = nullptr);

    Alarms unacknowledged() const { return m_board.unacknowledged(); }
    int acknowledgedCount() const { return m_board.acknowledgedCount(); }

    /// The dispatcher has seen these; ids of alarms that are gone do not matter.
    void acknowledge(const QList<quint64> &ids);

Q_SIGNALS:
    void raised(const gorizont::Alarm &alarm);
    /// unacknowledged() or acknowledgedCount() has changed; at most ten times a second.
    void changed();
    /// Time for a notification about these, the oldest first, at the pace of NoticePace.
    void noticeDue(const QList<gorizont::Alarm> &alarms);
    void journal(const gorizont::JournalEntry &entry);

private:
    void followLine(const LineStatus &status);
    void apply(const AlarmBoard::Change &change);
    void tellAcknowledged(const Alarms &alarms);
    void scheduleNotice(SteadyTime now);
    void giveNotice();

    AlarmBoard m_board;
    NoticePace m_pace;
    QTimer *m_changeTimer;
    QTimer *m_noticeTimer;
};

} // namespace gorizont
