#include "ui/service/servicesession.h"

namespace gorizont {

ServiceSession::ServiceSession(LineWorker &worker, const SensorRegistry &registry, int port, QObject *parent)
    : QObject(parent)
    , m_worker(worker)
    , m_registry(registry)
    , m_port(port)
{
    connect(&registry, &SensorRegistry::lineChanged, this, &ServiceSession::onLineChanged);
    connect(&m_entering, &QFutureWatcherBase::finished, this, [this] {
        const QFuture<Result<void>> future = m_entering.future();
        enter(future.resultCount() == 1 ? future.result() : Result<void>(Fault::Cancelled));
    });
}

ServiceSession::~ServiceSession()
{
    leave();
}

void ServiceSession::leave()
{
    m_waiting.clear();
    if (m_state == State::Active) {
        m_worker.leaveService();
    } else if (m_state == State::Entering) {
        // Nobody knows yet whether the port is ours; one that is somebody else's is left alone.
        m_entering.future().then([worker = &m_worker](const Result<void> &entered) {
            if (entered) {
                worker->leaveService();
            }
        });
        m_entering.setFuture({});
    }
    m_state = State::Over;
}

void ServiceSession::start()
{
    m_state = State::Entering;
    m_entering.setFuture(m_worker.enterService());
}

void ServiceSession::enter(const Result<void> &entered)
{
    if (entered) {
        m_state = State::Active;
        Q_EMIT started();
        startNext();
        return;
    }
    m_state = State::Over;
    switch (entered.fault()) {
    case Fault::Refused: Q_EMIT failed(tr("The port is in service already.")); break;
    case Fault::Cancelled: Q_EMIT failed(tr("The program is about to end.")); break;
    default: Q_EMIT failed(tr("The port is not open. Check the adapter and its cable.")); break;
    }
}

/// A port that goes away leaves service by itself; what comes later is no business of this session.
void ServiceSession::onLineChanged(const LineStatus &status)
{
    if (status.port == m_port && m_state == State::Active && status.state != LineState::Service) {
        m_state = State::Over;
        Q_EMIT ended(goneText());
    }
}

QString ServiceSession::goneText() const
{
    const int index = m_registry.lineIndexOf(m_port);
    const SensorRegistry::Line &line = m_registry.lines()[static_cast<std::size_t>(index)];
    return tr("%1 is gone (%2). Service has ended; polling goes on as soon as the port is back.")
        .arg(line.config.title(), line.status.lastError);
}

void ServiceSession::startNext()
{
    if (m_isBusy || m_waiting.empty() || m_state == State::New || m_state == State::Entering) {
        return;
    }
    m_isBusy = true;
    const auto next = std::move(m_waiting.front());
    m_waiting.pop_front();
    next();
}

} // namespace gorizont
