#pragma once

#include "core/engine/linepoller.h"
#include "core/values/linestatus.h"

#include <QMutex>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace gorizont {

/// Keeps one port open, lets its sensors have their turns, and tells the rest of the program. Lives in the thread of its port, where it
/// also makes the line and its timer; it may block there, but only inside the line. Only submit(), interrupt() and the
/// slots by queued connection are for other threads. Tells every event once per change of state.
class LineWorker : public QObject
{
    Q_OBJECT

public:
    using MakeLine = std::function<std::unique_ptr<Line>()>;
    using Task = std::function<void(Line &)>;

    LineWorker(PollingSettings settings, MakeLine makeLine);
    ~LineWorker() override;

    /// Runs \a task with the line between two turns, in the thread of the line. Thread-safe. The line may be closed;
    /// then its exchanges say so.
    void submit(Task task);

    /// Ends a running wait and every later one, so that the thread can be stopped. Thread-safe, final.
    void interrupt();

public Q_SLOTS:
    void start();
    /// Closes the line and stops the timer.
    void stop();
    /// Service: polling is suspended, tasks go on; the sensors keep their values. Leaving it starts polling again.
    void setService(bool isInService);

Q_SIGNALS:
    void readingsReady(const QList<gorizont::Reading> &readings);
    void blockReady(const gorizont::SampleBlock &block);
    void informationReady(const gorizont::DeviceInformation &information);
    void lineChanged(const gorizont::LineStatus &status);
    void journal(const gorizont::JournalEntry &entry);

private:
    void onTimer();
    void tryOpen();
    void lineLost();
    void turn();
    void schedule(SteadyTime at);
    void setState(LineState state);
    void publishLine();
    void tell(JournalKind kind, const QString &text, int number = 0);

    PollingSettings m_settings;
    MakeLine m_makeLine;
    std::unique_ptr<Line> m_line;
    QMutex m_lineMutex; ///< guards the pointer m_line against interrupt()
    bool m_isInterrupted = false; ///< guarded by m_lineMutex
    std::unique_ptr<QTimer> m_timer;
    LinePoller m_poller;
    LineStatus m_status;
    SteadyTime m_publishedAt{};
};

} // namespace gorizont
