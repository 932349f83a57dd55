#include "core/engine/lineworker.h"

#include "core/devices/drivercatalog.h"
#include "core/values/statustext.h"

#include <QCoreApplication>
#include <QLoggingCategory>
#include <QMutexLocker>

namespace gorizont {

namespace {

Q_LOGGING_CATEGORY(logLine, "gorizont.line", QtInfoMsg)

std::vector<std::unique_ptr<PolledSensor>> makeSensors(const LineWorkerSettings &settings)
{
    std::vector<std::unique_ptr<PolledSensor>> sensors;
    for (const SensorConfig &config : settings.line.sensors) {
        if (!config.isOn) {
            continue;
        }
        DriverSettings driver{
            config, settings.timing, settings.gravity, settings.ringPackets, settings.asksInformation};
        if (auto made = makeDriver(std::move(driver))) {
            sensors.push_back(std::make_unique<PolledSensor>(std::move(made), settings.rules));
        }
    }
    return sensors;
}

} // namespace

LineWorker::LineWorker(LineWorkerSettings settings, MakeLine makeLine)
    : m_settings(std::move(settings))
    , m_makeLine(std::move(makeLine))
    , m_sensors(makeSensors(m_settings))
    , m_cycle(static_cast<int>(m_sensors.size()), m_settings.timing)
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
            if (m_line) {
                task(*m_line);
            }
        },
        Qt::QueuedConnection);
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

void LineWorker::setService(bool isInService)
{
    if (isInService && m_status.state == LineState::Open) {
        m_timer->stop();
        setState(LineState::Service);
        tell(JournalKind::Off, tr("%1: polling suspended for service").arg(m_settings.line.title()));
    } else if (!isInService && m_status.state == LineState::Service) {
        tell(JournalKind::On, tr("%1: service ended, polling goes on").arg(m_settings.line.title()));
        setState(LineState::Open);
        m_cycle.restart(std::chrono::steady_clock::now());
        schedule(m_cycle.nextTurnAt());
    }
}

void LineWorker::onTimer()
{
    if (m_status.state == LineState::Open) {
        turn();
    } else if (m_status.state != LineState::Service) {
        tryOpen();
    }
}

void LineWorker::tryOpen()
{
    const auto opened = m_line->open();
    if (opened) {
        tell(JournalKind::On, tr("%1 is open").arg(m_settings.line.title()));
        setState(LineState::Open);
        m_cycle.restart(std::chrono::steady_clock::now());
        schedule(m_cycle.nextTurnAt());
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

/// One sensor, or one step of bulk data while the line is free; then back to the event loop.
void LineWorker::turn()
{
    if (!m_line->isOpen()) {
        lineLost();
        return;
    }
    const SteadyTime now = std::chrono::steady_clock::now();
    if (m_sensors.empty()) {
        schedule(now + m_settings.timing.run);
        return;
    }
    const bool goesOn = now < m_cycle.nextTurnAt() ? idleTurn() : sensorTurn(now);
    if (goesOn) {
        schedule(m_hasIdleWork ? std::chrono::steady_clock::now() : m_cycle.nextTurnAt());
    }
}

/// The turn of the sensor at the position of the cycle. False when the line was lost or interrupted.
bool LineWorker::sensorTurn(SteadyTime now)
{
    PolledSensor &sensor = *m_sensors[static_cast<std::size_t>(m_cycle.position())];
    bool isCycleOver = false;
    if (sensor.isDue(now)) {
        const auto pause = takeTurn(sensor);
        if (!pause) {
            return false;
        }
        isCycleOver = m_cycle.advance(std::chrono::steady_clock::now(), *pause);
    } else {
        isCycleOver = m_cycle.skip(now);
    }
    if (isCycleOver && std::chrono::steady_clock::now() - m_publishedAt >= m_settings.timing.updateInterval) {
        publishLine();
    }
    m_hasIdleWork = isCycleOver;
    return true;
}

/// Asks one sensor and tells what came of it. Returns the pause that its result asks for; empty when the line was lost
/// or interrupted.
std::optional<std::chrono::milliseconds> LineWorker::takeTurn(PolledSensor &sensor)
{
    const quint16 before = sensor.reading().status;
    changeAddress(sensor);
    const auto polled = sensor.poll(*m_line);
    if (!polled && !isSensorFault(polled.fault())) {
        return std::nullopt;
    }
    passNotes(sensor);
    tellStatusChange(sensor, before);
    Q_EMIT readingsReady({sensor.reading()});
    if (!polled) {
        return pauseAfter(polled.fault());
    }
    if (sensor.hasBacklog() && !fetchStep(sensor)) {
        return std::nullopt;
    }
    return std::chrono::milliseconds(0);
}

/// Closed: the line is lost, its new state is scheduled. Cancelled: the thread is about to end.
bool LineWorker::isSensorFault(Fault fault)
{
    if (fault == Fault::Closed) {
        lineLost();
    }
    return fault != Fault::Closed && fault != Fault::Cancelled;
}

/// SAdrChange: the line stays silent for a while before another sensor is asked.
void LineWorker::changeAddress(const PolledSensor &sensor)
{
    if (&sensor != m_lastAsked) {
        m_line->requireQuiet(m_settings.timing.addressChange);
        m_lastAsked = &sensor;
    }
}

/// Between two cycles the line is free: one step from whoever has a backlog, in turns, if the step fits before the next
/// cycle. False when the line was lost or interrupted over it.
bool LineWorker::idleTurn()
{
    const SteadyTime now = std::chrono::steady_clock::now();
    m_hasIdleWork = false;
    if (!m_cycle.isBetweenCycles()) {
        return true;
    }
    for (std::size_t i = 0; i < m_sensors.size(); ++i) {
        PolledSensor &sensor = *m_sensors[(m_nextFetch + i) % m_sensors.size()];
        if (sensor.hasBacklog() && sensor.isDue(now) && sensor.fetchTime() < m_cycle.nextTurnAt() - now) {
            m_nextFetch = (m_nextFetch + i + 1) % m_sensors.size();
            m_hasIdleWork = true;
            changeAddress(sensor);
            return fetchStep(sensor);
        }
    }
    return true;
}

/// One step of bulk data; false when the line was lost or interrupted over it.
bool LineWorker::fetchStep(PolledSensor &sensor)
{
    const auto blocks = sensor.fetch(*m_line);
    if (!blocks) {
        return isSensorFault(blocks.fault());
    }
    for (const SampleBlock &block : *blocks) {
        Q_EMIT blockReady(block);
    }
    passNotes(sensor);
    return true;
}

std::chrono::milliseconds LineWorker::pauseAfter(Fault fault) const
{
    return fault == Fault::Checksum ? m_settings.timing.crcErrorPause : m_settings.timing.readErrorPause;
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
        for (const auto &sensor : m_sensors) {
            if (state == LineState::Open) {
                sensor->restart();
            }
            sensor->lineBecame(state);
        }
        publishSensors();
    }
    publishLine();
}

void LineWorker::publishLine()
{
    m_publishedAt = std::chrono::steady_clock::now();
    m_status.bytesSent = m_line->bytesSent();
    m_status.bytesReceived = m_line->bytesReceived();
    m_status.writeErrors = m_line->writeErrors();
    m_status.readErrors = 0;
    m_status.crcErrors = 0;
    for (const auto &sensor : m_sensors) {
        m_status.readErrors += sensor->reading().counters.readErrors;
        m_status.crcErrors += sensor->reading().counters.crcErrors;
    }
    Q_EMIT lineChanged(m_status);
}

void LineWorker::publishSensors()
{
    QList<Reading> readings;
    for (const auto &sensor : m_sensors) {
        readings.append(sensor->reading());
    }
    if (!readings.isEmpty()) {
        Q_EMIT readingsReady(readings);
    }
}

void LineWorker::tell(JournalKind kind, const QString &text, int number)
{
    Q_EMIT journal({kind, utcNow(), text, m_settings.line.index, number});
}

/// One line when a critical code comes, changes or goes; a port that comes back does not bring a line for each sensor.
void LineWorker::tellStatusChange(const PolledSensor &sensor, quint16 before)
{
    const StatusCode was = statusCode(before);
    const StatusCode is = statusCode(sensor.reading().status);
    if (was == is) {
        return;
    }
    const QString title = sensorTitle(sensor.config(), m_settings.line);
    if (is == StatusCode::Good) {
        tell(JournalKind::On, tr("%1 works normally again").arg(title), sensor.config().number);
    } else {
        tell(JournalKind::Error, QStringLiteral("%1: %2").arg(title, statusText(is)), sensor.config().number);
    }
}

void LineWorker::passNotes(PolledSensor &sensor)
{
    for (const DriverNote &note : sensor.driver().takeNotes()) {
        tell(
            note.kind, QStringLiteral("%1: %2").arg(sensorTitle(sensor.config(), m_settings.line), note.text),
            sensor.config().number);
    }
}

} // namespace gorizont
