#include "core/engine/linepoller.h"

#include "core/devices/drivercatalog.h"
#include "core/values/statustext.h"

#include <QCoreApplication>

#include <algorithm>
#include <numeric>

namespace gorizont {

namespace {

class PollerText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::LinePoller)
};

std::vector<std::unique_ptr<PolledSensor>> makeSensors(const PollingSettings &settings)
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

/// One message is enough for all devices of a line.
std::optional<KeepAlive> keepAliveOf(const std::vector<std::unique_ptr<PolledSensor>> &sensors)
{
    for (const auto &sensor : sensors) {
        if (auto keepAlive = sensor->driver().keepAlive()) {
            return keepAlive;
        }
    }
    return std::nullopt;
}

SteadyTime now()
{
    return std::chrono::steady_clock::now();
}

} // namespace

LinePoller::LinePoller(const PollingSettings &settings)
    : m_settings(settings)
    , m_sensors(makeSensors(settings))
    , m_cycle(static_cast<int>(m_sensors.size()), settings.timing)
    , m_care(keepAliveOf(m_sensors))
{
}

void LinePoller::restart()
{
    m_toFetch = nullptr;
    m_lastAsked = nullptr;
    m_cycle.restart(now());
    m_care.restart(now());
    for (const auto &sensor : m_sensors) {
        sensor->restart();
    }
}

void LinePoller::probeParked()
{
    for (const auto &sensor : m_sensors) {
        sensor->probeSoon();
    }
}

Readings LinePoller::lineBecame(LineState state)
{
    Readings readings;
    for (const auto &sensor : m_sensors) {
        sensor->lineBecame(state);
        readings.append(sensor->reading());
    }
    return readings;
}

TurnReport LinePoller::turn(Line &line)
{
    TurnReport report;
    if (m_sensors.empty()) {
        report.nextAt = now() + m_settings.timing.run;
        return report;
    }
    if (m_care.isSilent(now())) {
        report.nextAt = m_care.silentUntil();
        return report;
    }
    if (const auto awake = keepAwake(line); !awake) {
        report.lineFault = awake.fault();
        return report;
    }
    if (PolledSensor *sensor = std::exchange(m_toFetch, nullptr)) {
        fetch(*sensor, line, report);
    } else if (now() < m_cycle.nextTurnAt()) {
        idleTurn(line, report);
    } else {
        sensorTurn(line, report);
    }
    m_care.look(line.bytesSent(), now());
    report.nextAt = m_toFetch || m_mayHaveBacklog ? now() : nextTurnAt();
    return report;
}

SteadyTime LinePoller::nextTurnAt() const
{
    const SteadyTime cycleAt = m_cycle.nextTurnAt();
    SteadyTime next = std::min(cycleAt, m_care.nextAt().value_or(cycleAt));
    if (!m_cycle.isBetweenCycles()) {
        return next;
    }
    // What is due already did not fit before the next cycle, or its sensor is parked.
    for (const auto &sensor : m_sensors) {
        const auto backlogAt = sensor->driver().backlogAt();
        next = backlogAt && *backlogAt > now() ? std::min(next, *backlogAt) : next;
    }
    return next;
}

Result<void> LinePoller::keepAwake(Line &line)
{
    m_care.look(line.bytesSent(), now());
    const QByteArray message = m_care.due(now());
    if (message.isEmpty()) {
        return {};
    }
    const auto sent = line.send(message, m_settings.timing.writeCommand, m_settings.timing.addressChange);
    m_care.look(line.bytesSent(), now());
    return sent;
}

/// A device that hangs restarts when nobody says anything for a while; all others of the line wait for it.
void LinePoller::silenceFor(PolledSensor &sensor, TurnReport &report)
{
    const std::chrono::seconds silence = sensor.driver().takeSilence();
    if (silence > std::chrono::seconds(0) && m_care.mayBeSilenced(now())) {
        m_care.keepSilent(silence, now());
        report.events.append(
            {JournalKind::Info,
             PollerText::tr("%1 does not answer; its port is silent for %2 s, so that it restarts")
                 .arg(sensorTitle(sensor.config(), m_settings.line))
                 .arg(silence.count()),
             sensor.config().number});
    }
}

/// Bulk data wait for the free time after a cycle, so that the periods of the sensors stay even. Only when that was too
/// short for them does every sensor that has some get one step right after its turn.
void LinePoller::sensorTurn(Line &line, TurnReport &report)
{
    if (m_cycle.isBetweenCycles()) {
        m_isBehind = hasBacklog();
    }
    PolledSensor &sensor = *m_sensors[static_cast<std::size_t>(m_cycle.position())];
    if (sensor.isDue(now())) {
        poll(sensor, line, report);
    } else {
        report.isCycleOver = m_cycle.skip(now());
    }
    m_mayHaveBacklog = report.isCycleOver;
}

/// Between two cycles the line is free: one step from whoever has a backlog, in turns, if the step fits before the next
/// cycle.
void LinePoller::idleTurn(Line &line, TurnReport &report)
{
    m_mayHaveBacklog = false;
    if (!m_cycle.isBetweenCycles()) {
        return;
    }
    const auto left = m_cycle.nextTurnAt() - now();
    for (std::size_t i = 0; i < m_sensors.size(); ++i) {
        PolledSensor &sensor = *m_sensors[(m_nextIdle + i) % m_sensors.size()];
        if (sensor.hasBacklog() && sensor.isDue(now()) && sensor.fetchTime() < left) {
            m_nextIdle = (m_nextIdle + i + 1) % m_sensors.size();
            m_mayHaveBacklog = true;
            fetch(sensor, line, report);
            return;
        }
    }
}

void LinePoller::poll(PolledSensor &sensor, Line &line, TurnReport &report)
{
    const quint16 before = sensor.reading().status;
    changeAddress(sensor, line);
    const auto polled = sensor.poll(line);
    if (!polled && isLineFault(polled.fault())) {
        report.lineFault = polled.fault();
        return;
    }
    addWords(sensor, report);
    addStatusChange(sensor, before, report);
    if (!polled) {
        silenceFor(sensor, report);
    }
    report.readings.append(sensor.reading());
    m_toFetch = m_isBehind && polled && sensor.hasBacklog() ? &sensor : nullptr;
    report.isCycleOver = m_cycle.advance(now(), pauseAfter(polled));
}

void LinePoller::fetch(PolledSensor &sensor, Line &line, TurnReport &report)
{
    changeAddress(sensor, line);
    const auto blocks = sensor.fetch(line);
    if (blocks) {
        report.blocks = *blocks;
    } else if (isLineFault(blocks.fault())) {
        report.lineFault = blocks.fault();
    }
    addWords(sensor, report);
}

bool LinePoller::hasBacklog() const
{
    return std::any_of(m_sensors.begin(), m_sensors.end(), [](const auto &sensor) { return sensor->hasBacklog(); });
}

/// SAdrChange: the line stays silent for a while before another sensor is asked.
void LinePoller::changeAddress(const PolledSensor &sensor, Line &line)
{
    if (&sensor != m_lastAsked) {
        line.requireQuiet(m_settings.timing.addressChange);
        m_lastAsked = &sensor;
    }
}

std::chrono::milliseconds LinePoller::pauseAfter(const Result<void> &polled) const
{
    if (polled) {
        return std::chrono::milliseconds(0);
    }
    return polled.fault() == Fault::Checksum ? m_settings.timing.crcErrorPause : m_settings.timing.readErrorPause;
}

/// One line when a critical code comes, changes or goes.
void LinePoller::addStatusChange(const PolledSensor &sensor, quint16 before, TurnReport &report) const
{
    const StatusCode is = statusCode(sensor.reading().status);
    if (statusCode(before) == is) {
        return;
    }
    const QString title = sensorTitle(sensor.config(), m_settings.line);
    const int number = sensor.config().number;
    if (is == StatusCode::Good) {
        report.events.append({JournalKind::On, PollerText::tr("%1 works normally again").arg(title), number});
    } else {
        report.events.append(
            {JournalKind::Error, QStringLiteral("%1: %2").arg(title, statusText(sensor.reading())), number});
    }
}

/// What the driver has to say beside values.
void LinePoller::addWords(PolledSensor &sensor, TurnReport &report) const
{
    report.information = sensor.driver().takeInformation();
    report.captures += sensor.driver().takeCaptures();
    for (const DriverNote &note : sensor.driver().takeNotes()) {
        const QString title = sensorTitle(sensor.config(), m_settings.line);
        report.events.append({note.kind, QStringLiteral("%1: %2").arg(title, note.text), sensor.config().number});
    }
}

quint64 LinePoller::readErrors() const
{
    return std::accumulate(m_sensors.begin(), m_sensors.end(), quint64(0), [](quint64 sum, const auto &sensor) {
        return sum + sensor->reading().counters.readErrors;
    });
}

quint64 LinePoller::crcErrors() const
{
    return std::accumulate(m_sensors.begin(), m_sensors.end(), quint64(0), [](quint64 sum, const auto &sensor) {
        return sum + sensor->reading().counters.crcErrors;
    });
}

} // namespace gorizont
