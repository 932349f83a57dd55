#include "core/archive/gapledger.h"

#include "core/values/statusword.h"

#include <algorithm>
#include <utility>

namespace gorizont {

namespace {

std::optional<GapReason> reasonOf(LineState state)
{
    switch (state) {
    case LineState::Off: return GapReason::PortOff;
    case LineState::OpenFailed:
    case LineState::Lost: return GapReason::PortError;
    case LineState::Service: return GapReason::Service;
    case LineState::Opening:
    case LineState::Open: break;
    }
    return {};
}

bool hasValidValue(const Reading &reading, const QList<Quantity> &quantities)
{
    return reading.isAnswer && std::any_of(quantities.begin(), quantities.end(), [&reading](Quantity quantity) {
               return valueOf(reading, quantity).has_value();
           });
}

} // namespace

GapLedger::GapLedger(const QList<LineConfig> &lines, const Rules &rules)
    : m_rules(rules)
{
    for (const LineConfig &line : lines) {
        m_lines.insert(line.index, line.isOn ? LineState::Opening : LineState::Off);
        for (const SensorConfig &config : line.sensors) {
            Sensor sensor;
            sensor.port = line.index;
            sensor.isOn = config.isOn;
            sensor.quantities = quantitiesOf(config);
            m_sensors.emplace(config.number, sensor);
        }
    }
}

void GapLedger::start(UtcTime now, const QHash<int, UtcTime> &knownUntil)
{
    m_startedAt = now;
    for (auto &[number, sensor] : m_sensors) {
        sensor.seenAt = now;
        sensor.validAt = std::min(knownUntil.value(number, now), now);
        if (*sensor.validAt < now) {
            begin(number, sensor, GapReason::ProgramStopped, true, now);
        }
        if (!sensor.isOn) {
            begin(number, sensor, GapReason::SensorOff, true, now);
        } else if (const auto reason = reasonOf(m_lines.value(sensor.port))) {
            begin(number, sensor, *reason, true, now);
        }
    }
}

void GapLedger::stop(UtcTime now)
{
    for (auto &[number, sensor] : m_sensors) {
        end(sensor, now);
    }
}

void GapLedger::add(const Reading &reading)
{
    const auto found = m_sensors.find(reading.number);
    if (found == m_sensors.end()) {
        return;
    }
    Sensor &sensor = found->second;
    const bool hasCrcError = reading.counters.crcErrors > sensor.crcErrors;
    sensor.crcErrors = reading.counters.crcErrors;
    sensor.period = reading.period;
    const UtcTime at = std::max(reading.time, sensor.validAt.value_or(reading.time));
    sensor.seenAt = std::max(at, sensor.seenAt.value_or(at));
    if (hasValidValue(reading, sensor.quantities)) {
        end(sensor, reading.time);
        sensor.validAt = reading.time;
    } else if (const auto reason = certainReason(reading, sensor)) {
        begin(reading.number, sensor, *reason, true, at);
    } else {
        begin(reading.number, sensor, hasCrcError ? GapReason::Crc : GapReason::NoAnswer, false, at);
    }
}

/// Empty: so far it could be anything.
std::optional<GapReason> GapLedger::certainReason(const Reading &reading, const Sensor &sensor) const
{
    if (reading.status & statusbit::NotPolled) {
        return GapReason::SensorOff;
    }
    switch (statusCode(reading.status)) {
    case StatusCode::PortOff: return GapReason::PortOff;
    case StatusCode::PortError: return GapReason::PortError;
    case StatusCode::NoAnswer: return GapReason::NoAnswer;
    case StatusCode::CrcErrors: return GapReason::Crc;
    default: break;
    }
    return reading.isAnswer ? std::optional(GapReason::DeviceFault) : reasonOf(m_lines.value(sensor.port));
}

void GapLedger::add(const LineStatus &status, UtcTime now)
{
    m_lines.insert(status.port, status.state);
    const auto reason = reasonOf(status.state);
    for (auto &[number, sensor] : m_sensors) {
        if (reason && sensor.port == status.port && sensor.isOn) {
            begin(number, sensor, *reason, true, std::max(now, sensor.validAt.value_or(now)));
        }
    }
}

/// A reason that is not certain yet gives way to one that is; a certain one never to a guess.
void GapLedger::begin(int number, Sensor &sensor, GapReason reason, bool isCertain, UtcTime at)
{
    if (!sensor.gap) {
        const UtcTime from = sensor.validAt.value_or(at);
        sensor.gap = Gap{number, from, {}, reason, {}};
        sensor.isReasonCertain = isCertain;
        return;
    }
    Gap &gap = *sensor.gap;
    if (gap.reason == reason || !isCertain) {
        sensor.isReasonCertain = sensor.isReasonCertain || (isCertain && gap.reason == reason);
        return;
    }
    const UtcTime turn = gap.reason == GapReason::ProgramStopped ? std::max(m_startedAt, gap.from) : at;
    if (!sensor.isReasonCertain || (!sensor.isGapTold && turn - gap.from < m_rules.shortest)) {
        gap.reason = reason;
        sensor.isReasonCertain = true;
        if (sensor.isGapTold) {
            m_changes.append(gap);
        }
        return;
    }
    end(sensor, turn);
    sensor.gap = Gap{number, turn, {}, reason, {}};
    sensor.isReasonCertain = true;
}

void GapLedger::end(Sensor &sensor, UtcTime at)
{
    if (!sensor.gap) {
        return;
    }
    Gap gap = *std::exchange(sensor.gap, std::nullopt);
    const UtcTime to = std::max(at, gap.from);
    gap.to = to;
    sensor.validAt = to;
    if (std::exchange(sensor.isGapTold, false) || to - gap.from >= m_rules.shortest) {
        m_changes.append(gap);
    }
}

void GapLedger::clockStepped(UtcTime before, UtcTime after)
{
    for (auto &[number, sensor] : m_sensors) {
        sensor.seenAt = after;
        if (sensor.gap && after < before) {
            const Gap gap = *sensor.gap;
            end(sensor, before);
            sensor.gap = Gap{number, after, {}, gap.reason, {}};
        } else if (!sensor.gap && after > before && sensor.validAt) {
            m_changes.append({number, before, after, GapReason::Clock, {}});
        }
        sensor.validAt = after;
    }
}

void GapLedger::addLost(int number, const TimeSpan &span)
{
    if (span.from < span.to) {
        m_changes.append({number, span.from, span.to, GapReason::Disk, {}});
    }
}

void GapLedger::tick(UtcTime now)
{
    for (auto &[number, sensor] : m_sensors) {
        if (!sensor.gap && sensor.seenAt && now - *sensor.seenAt > std::max(m_rules.silence, 5 * sensor.period)) {
            begin(number, sensor, GapReason::NoAnswer, false, now);
        }
        if (sensor.gap && !sensor.isGapTold && now - sensor.gap->from >= m_rules.shortest) {
            sensor.isGapTold = true;
            m_changes.append(*sensor.gap);
        }
    }
}

QList<Gap> GapLedger::takeChanges()
{
    return std::exchange(m_changes, {});
}

} // namespace gorizont
