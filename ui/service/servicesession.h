#pragma once

#include "core/engine/lineworker.h"
#include "core/registry/sensorregistry.h"

#include <QFutureWatcher>
#include <QPointer>

#include <deque>

namespace gorizont {

/// One port in service for as long as this object lives: enters, lets steps run in the thread of the line one after
/// another, and leaves in its destructor at the latest, so that polling goes on however a dialog ends. GUI thread. The worker outlives it.
class ServiceSession : public QObject
{
    Q_OBJECT

public:
    ServiceSession(LineWorker &worker, const SensorRegistry &registry, int port, QObject *parent = nullptr);
    ~ServiceSession() override;

    void start();
    /// Polling goes on; steps that wait are forgotten. Final.
    void leave();
    bool isActive() const { return m_state == State::Active; }
    bool isIdle() const { return isActive() && !m_isBusy; } ///< no step runs or waits

    /// Runs \a step, a function from Line & to Result<T>, in the thread of the line after those that wait already, and then
    /// \a answer with its result in this one. Every step is answered (Closed: the port is gone; Cancelled: its thread
    /// ended) unless the session is left or destroyed before.
    template <typename Step, typename Answer> void run(Step step, Answer answer);

Q_SIGNALS:
    void started();
    /// The port could not be had; \a reason is a sentence for the user.
    void failed(const QString &reason);
    /// The port went away by itself.
    void ended(const QString &reason);

private:
    enum class State : quint8 { New, Entering, Active, Over };

    void enter(const Result<void> &entered);
    void onLineChanged(const LineStatus &status);
    void startNext();
    QString goneText() const;

    LineWorker &m_worker;
    const SensorRegistry &m_registry;
    int m_port;
    State m_state = State::New;
    QFutureWatcher<Result<void>> m_entering;
    std::deque<std::function<void()>> m_waiting;
    bool m_isBusy = false;
};

template <typename Step, typename Answer> void ServiceSession::run(Step step, Answer answer)
{
    using Outcome = std::invoke_result_t<Step, Line &>;
    m_waiting.push_back([this, step = std::move(step), answer = std::move(answer)] {
        auto *watcher = new QFutureWatcher<Outcome>(this);
        connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, answer] {
            const QFuture<Outcome> future = watcher->future();
            watcher->deleteLater();
            m_isBusy = false;
            const QPointer<ServiceSession> self(this);
            answer(future.resultCount() == 1 ? future.result() : Outcome(Fault::Cancelled));
            if (self) {
                startNext();
            }
        });
        watcher->setFuture(isActive() ? m_worker.serve(step) : QtFuture::makeReadyFuture(Outcome(Fault::Closed)));
    });
    startNext();
}

} // namespace gorizont
