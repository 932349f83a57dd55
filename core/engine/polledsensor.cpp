#include "core/engine/polledsensor.h"

namespace gorizont {

namespace {

std::chrono::microseconds between(SteadyTime from, SteadyTime to)
{
    return std::chrono::duration_cast<std::chrono::microseconds>(to - from);
}

} // namespace

PolledSensor::PolledSensor(std::unique_ptr<Driver> driver, const StatusRules &rules)
    : m_driver(std::move(driver))
    , m_rules(rules)
    , m_transform(config())
    , m_health(rules.readErrorLimit, rules.crcErrorLimit)
    , m_window(m_transform)
{
    m_reading.number = config().number;
    updateStatus();
}

Result<void> PolledSensor::poll(Line &line)
{
    const SteadyTime started = std::chrono::steady_clock::now();
    const auto measurement = m_driver->poll(line);
    const SteadyTime ended = std::chrono::steady_clock::now();
    m_reading.time = utcNow();
    m_reading.isAnswer = static_cast<bool>(measurement);
    m_reading.exchange = between(started, ended);
    m_reading.period = m_turnAt ? between(*m_turnAt, started) : std::chrono::microseconds(0);
    m_turnAt = started;
    if (measurement) {
        take(*measurement, ended);
        return {};
    }
    countFailure(measurement.fault(), ended);
    updateStatus();
    return measurement.fault();
}

void PolledSensor::take(const Measurement &measurement, SteadyTime now)
{
    m_health.succeeded();
    ++m_reading.counters.answers;
    updateAcceleration(now);
    m_situation.hasAnswered = true;
    m_situation.conditions = measurement.conditions;
    m_situation.heaterPower = measurement.heaterPower;
    m_situation.hasTilt = measurement.tilt.has_value();
    m_situation.hasTemperature = measurement.temperature.has_value();
    updateStatus();

    m_reading.answeredAt = now;
    m_reading.heaterPower = measurement.heaterPower;
    m_reading.fanFrequency = measurement.fanFrequency;
    m_reading.rawStatus = measurement.rawStatus;
    m_reading.rawMode = measurement.rawMode;
    m_reading.ring = measurement.ring;
    m_reading.vibration = measurement.vibration;
    m_reading.weather = measurement.weather;
    // What is not valid keeps its last value beside the flag.
    if (isTiltValid(m_reading.status) && measurement.tilt) {
        m_reading.tilt = correctedTilt(*measurement.tilt, m_transform, config());
        m_reading.variation = measurement.variation;
    }
    if (isTemperatureValid(m_reading.status) && measurement.temperature) {
        m_reading.temperature = *measurement.temperature - config().offsetT;
    }
}

void PolledSensor::countFailure(Fault fault, SteadyTime now)
{
    if (isLineFault(fault)) {
        return;
    }
    ++(fault == Fault::Checksum ? m_reading.counters.crcErrors : m_reading.counters.readErrors);
    m_health.failed(fault, now);
}

/// Statistics are of the last minute: without new samples for so long they are over.
void PolledSensor::updateAcceleration(SteadyTime now)
{
    if (m_lastBlockAt && now - *m_lastBlockAt > AccelWindow::length) {
        m_window.clear();
        m_lastBlockAt.reset();
    }
    const auto statistics = m_window.statistics();
    m_situation.hasAcceleration = statistics.has_value();
    if (statistics) {
        m_reading.acceleration = statistics;
    }
}

Result<QList<SampleBlock>> PolledSensor::fetch(Line &line)
{
    const SteadyTime started = std::chrono::steady_clock::now();
    auto blocks = m_driver->fetch(line);
    const SteadyTime ended = std::chrono::steady_clock::now();
    m_fetchTime = between(started, ended);
    if (!blocks) {
        countFailure(blocks.fault(), ended);
        updateStatus();
        return blocks;
    }
    for (const SampleBlock &block : *blocks) {
        m_window.add(block);
        m_lastBlockAt = ended;
    }
    return blocks;
}

void PolledSensor::lineBecame(LineState state)
{
    m_situation.line = state;
    m_situation.hasAnswered = false;
    m_reading.time = utcNow();
    m_reading.isAnswer = false;
    updateStatus();
}

void PolledSensor::restart()
{
    m_health.restart();
    m_driver->restart();
    m_turnAt.reset();
}

void PolledSensor::updateStatus()
{
    m_situation.readErrorsInRow = m_health.readErrorsInRow();
    m_situation.crcErrorsInRow = m_health.crcErrorsInRow();
    m_reading.status = sensorWord(config(), m_situation, m_rules);
}

} // namespace gorizont
