#pragma once

#include "core/engine/linepoller.h"
#include "core/values/linestatus.h"

#include <QFuture>
#include <QMutex>
#include <QObject>
#include <QPromise>
#include <QTimer>

#include <functional>
#include <memory>
#include <type_traits>

namespace gorizont {

/// Keeps one port open, lets its sensors have their turns, and tells the rest of the program. Lives in the thread of its port, where it
/// also makes the line and its timer; it may block there, but only inside the line. Other threads call only what says that
/// it is thread-safe. Tells every event once per change of state.
class LineWorker : public QObject
{
    Q_OBJECT

public:
    using MakeLine = std::function<std::unique_ptr<Line>()>;
    using Task = std::function<void(Line &)>;

    LineWorker(PollingSettings settings, MakeLine makeLine);
    ~LineWorker() override;

    /// Runs \a task with the line between two turns, in the thread of the line. Thread-safe. The line may be closed;
    /// then its exchanges say so. A task that comes after the end of the thread is destroyed unheard.
    void submit(Task task);

    /// Suspends polling for service; the sensors keep their values. Closed: the port is not open. Refused: it is in service
    /// already. Thread-safe.
    QFuture<Result<void>> enterService();
    /// Starts polling again; nothing happens if the port is not in service. Thread-safe.
    void leaveService();

    /// Runs \a step, a function from Line & to Result<T>, in the thread of the line, if the port is in service; else the
    /// answer is Closed. Thread-safe. The future is cancelled when the thread ends first. A step is bounded: a few
    /// exchanges, so that the end of service is heard soon.
    template <typename Step> auto serve(Step step) -> QFuture<std::invoke_result_t<Step, Line &>>;

    /// Opens a closed port and asks parked sensors at once, without waiting for PReOpen, PClose or the next probe.
    /// Thread-safe.
    void retry();

    /// In service nothing is said on the line for \a length unless a step says it, so that the watchdogs of devices that hang
    /// restart them. Thread-safe.
    void keepSilent(std::chrono::seconds length);

    /// Ends a running wait and every later one, so that the thread can be stopped. Thread-safe, final.
    void interrupt();

public Q_SLOTS:
    void start();
    /// Closes the line and stops the timer.
    void stop();

Q_SIGNALS:
    void readingsReady(const QList<gorizont::Reading> &readings);
    void blockReady(const gorizont::SampleBlock &block);
    void captureReady(const gorizont::SignalCapture &captured);
    void informationReady(const gorizont::DeviceInformation &information);
    void lineChanged(const gorizont::LineStatus &status);
    void journal(const gorizont::JournalEntry &entry);

private:
    void onTimer();
    void tryOpen();
    void lineLost();
    void turn();
    void watch();
    Result<void> suspend();
    void resume();
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

template <typename Step> auto LineWorker::serve(Step step) -> QFuture<std::invoke_result_t<Step, Line &>>
{
    using Answer = std::invoke_result_t<Step, Line &>;
    auto promise = std::make_shared<QPromise<Answer>>();
    promise->start();
    submit([this, promise, step = std::move(step)](Line &line) mutable {
        promise->addResult(m_status.state == LineState::Service ? step(line) : Answer(Fault::Closed));
        promise->finish();
    });
    return promise->future();
}

} // namespace gorizont
