#include "core/engine/lineworker.h"

#include <QCoreApplication>
#include <QLoggingCategory>
#include <QMutexLocker>

namespace gorizont {

namespace {

Q_LOGGING_CATEGORY(logLine, "gorizont.line", QtInfoMsg)

/// How often a port in service is looked at while nobody uses it, so that one that was pulled out does not go unnoticed.
constexpr std::chrono::seconds watchPeriod(1);

} // namespace

LineWorker::LineWorker(PollingSettings settings, MakeLine makeLine)
    : m_settings(std::move(settings))
    , m_makeLine(std::move(makeLine))
    , m_poller(m_settings)
{
    m_status.port = m_settings.line.index;
    m_status.state = LineState::Opening;
}

LineWorker::~LineWorker() = default;

void LineWorker::submit(Task task)
{
    QMetaObject::invokeMethod(
        this,
        [this, task = std::move(task)] {
            if (!m_line) {
                return;
            }
            task(*m_line);
            if (m_status.state == LineState::Service && !m_line->isOpen()) {
                lineLost();
            }
        },
        Qt::QueuedConnection);
}

QFuture<Result<void>> LineWorker::enterService()
{
    auto promise = std::make_shared<QPromise<Result<void>>>();
    promise->start();
    submit([this, promise](Line &) {
        promise->addResult(suspend());
        promise->finish();
    });
    return promise->future();
}

void LineWorker::leaveService()
{
    submit([this](Line &) { resume(); });
}

void LineWorker::retry()
{
    submit([this](Line &) {
        if (m_status.state == LineState::Lost || m_status.state == LineState::OpenFailed) {
            tryOpen();
        } else if (m_status.state == LineState::Open) {
            m_poller.probeParked();
            schedule(std::chrono::steady_clock::now());
        }
    });
}

void LineWorker::keepSilent(std::chrono::seconds length)
{
    submit([this, length](Line &) { m_poller.keepSilent(length); });
}

void LineWorker::interrupt()
{
    const QMutexLocker lock(&m_lineMutex);
    m_isInterrupted = true;
    if (m_line) {
        m_line->interrupt();
    }
}

void LineWorker::start()
{
    {
        const QMutexLocker lock(&m_lineMutex);
        m_line = m_makeLine();
        if (m_isInterrupted) {
            m_line->interrupt();
        }
    }
    m_timer = std::make_unique<QTimer>();
    m_timer->setSingleShot(true);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer.get(), &QTimer::timeout, this, &LineWorker::onTimer);
    tryOpen();
}

void LineWorker::stop()
{
    m_timer.reset();
    const QMutexLocker lock(&m_lineMutex);
    m_line.reset();
}

Result<void> LineWorker::suspend()
{
    if (m_status.state != LineState::Open) {
        return m_status.state == LineState::Service ? Fault::Refused : Fault::Closed;
    }
    setState(LineState::Service);
    tell(JournalKind::Off, tr("%1: polling suspended for service").arg(m_settings.line.title()));
    schedule(std::chrono::steady_clock::now() + watchPeriod);
    return {};
}

void LineWorker::resume()
{
    if (m_status.state != LineState::Service) {
        return;
    }
    tell(JournalKind::On, tr("%1: service ended, polling goes on").arg(m_settings.line.title()));
    setState(LineState::Open);
    schedule(std::chrono::steady_clock::now());
}

void LineWorker::onTimer()
{
    if (m_status.state == LineState::Open) {
        turn();
    } else if (m_status.state == LineState::Service) {
        watch();
    } else {
        tryOpen();
    }
}

void LineWorker::watch()
{
    const auto heard = m_line->discardInput();
    const auto awake = heard ? m_poller.keepAwake(*m_line) : heard;
    if (!awake && awake.fault() == Fault::Closed) {
        lineLost();
    } else {
        schedule(std::chrono::steady_clock::now() + watchPeriod);
    }
}

void LineWorker::tryOpen()
{
    const auto opened = m_line->open();
    if (opened) {
        tell(JournalKind::On, tr("%1 is open").arg(m_settings.line.title()));
        setState(LineState::Open);
        schedule(std::chrono::steady_clock::now());
        return;
    }
    if (opened.fault() == Fault::Cancelled) {
        return;
    }
    ++m_status.failedOpens;
    m_status.lastErrorCode = m_line->lastError().code;
    m_status.lastError = m_line->lastError().text;
    if (m_status.state == LineState::Opening) {
        tell(
            JournalKind::Error,
            tr("%1 cannot be opened (%2). Check the adapter and its port number; the program keeps trying.")
                .arg(m_settings.line.title(), m_line->lastError().text));
    }
    setState(LineState::OpenFailed);
    schedule(std::chrono::steady_clock::now() + m_settings.timing.reopenPause);
}

void LineWorker::lineLost()
{
    m_line->close();
    m_status.lastErrorCode = m_line->lastError().code;
    m_status.lastError = m_line->lastError().text;
    tell(
        JournalKind::Error,
        tr("%1 is gone (%2). Check the adapter and its cable; the program opens the port again as soon as it can.")
            .arg(m_settings.line.title(), m_line->lastError().text));
    setState(LineState::Lost);
    schedule(std::chrono::steady_clock::now() + m_settings.timing.closePause);
}

/// One turn, then back to the event loop, so that tasks and the end of the program are heard between any two.
void LineWorker::turn()
{
    if (!m_line->isOpen()) {
        lineLost();
        return;
    }
    const TurnReport report = m_poller.turn(*m_line);
    for (const TurnReport::Event &event : report.events) {
        tell(event.kind, event.text, event.number);
    }
    if (!report.readings.isEmpty()) {
        Q_EMIT readingsReady(report.readings);
    }
    for (const SampleBlock &block : report.blocks) {
        Q_EMIT blockReady(block);
    }
    for (const SignalCapture &captured : report.captures) {
        Q_EMIT captureReady(captured);
    }
    if (report.information) {
        Q_EMIT informationReady(*report.information);
    }
    if (report.lineFault == Fault::Closed) {
        lineLost();
    }
    if (report.lineFault) {
        return;
    }
    if (report.isCycleOver && std::chrono::steady_clock::now() - m_publishedAt >= m_settings.timing.updateInterval) {
        publishLine();
    }
    schedule(report.nextAt);
}

void LineWorker::schedule(SteadyTime at)
{
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(at - std::chrono::steady_clock::now());
    m_timer->start(std::max(wait, std::chrono::milliseconds(0)));
}

void LineWorker::setState(LineState state)
{
    const bool wasOpen = m_status.state == LineState::Open || m_status.state == LineState::Service;
    const bool isOpen = state == LineState::Open || state == LineState::Service;
    const bool isChanged = m_status.state != state;
    const SteadyTime now = std::chrono::steady_clock::now();
    m_status.state = state;
    if (isOpen != wasOpen) {
        m_status.openedAt = isOpen ? std::optional(now) : std::nullopt;
    }
    m_status.pollingAt = state == LineState::Open ? std::optional(now) : std::nullopt;
    if (isChanged) {
        qCDebug(logLine) << m_settings.line.title() << "state" << static_cast<int>(state);
        if (state == LineState::Open) {
            m_poller.restart();
        }
        if (const Readings readings = m_poller.lineBecame(state); !readings.isEmpty()) {
            Q_EMIT readingsReady(readings);
        }
    }
    publishLine();
}

void LineWorker::publishLine()
{
    m_publishedAt = std::chrono::steady_clock::now();
    m_status.bytesSent = m_line->bytesSent();
    m_status.bytesReceived = m_line->bytesReceived();
    m_status.writeErrors = m_line->writeErrors();
    m_status.readErrors = m_poller.readErrors();
    m_status.crcErrors = m_poller.crcErrors();
    Q_EMIT lineChanged(m_status);
}

void LineWorker::tell(JournalKind kind, const QString &text, int number)
{
    Q_EMIT journal({kind, utcNow(), text, m_settings.line.index, number});
}

} // namespace gorizont
