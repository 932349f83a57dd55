#include "core/values/statusword.h"

#include <array>

namespace gorizont {

namespace {

using namespace statusbit;

constexpr quint16 allInvalid = TiltInvalid | TemperatureInvalid | AccelerationInvalid;

constexpr quint16 word(StatusCode code, quint16 flags)
{
    return static_cast<quint16>((static_cast<quint16>(code) << 12) | flags);
}

/// The first of the device's own complaints; those of fan and heater count only where there is a thermostat.
StatusCode conditionCode(const SensorConfig &sensor, Conditions conditions)
{
    struct Row
    {
        Condition condition;
        StatusCode code;
        bool needsThermostat;
    };
    static constexpr std::array<Row, 7> rows{{
        {Condition::TransducerSilent, StatusCode::TransducerSilent, false},
        {Condition::TransducerCrc, StatusCode::TransducerCrc, false},
        {Condition::TransducerRange, StatusCode::TransducerRange, false},
        {Condition::TemperatureReadError, StatusCode::TemperatureSensor, false},
        {Condition::TemperatureRange, StatusCode::TemperatureRange, false},
        {Condition::FanError, StatusCode::Fan, true},
        {Condition::ThermostatError, StatusCode::Thermostat, true},
    }};
    for (const Row &row : rows) {
        if (conditions.testFlag(row.condition) && (sensor.hasThermostat || !row.needsThermostat)) {
            return row.code;
        }
    }
    return StatusCode::Good;
}

quint16 validityFlags(const SensorConfig &sensor, const SensorSituation &situation)
{
    const Conditions has = situation.conditions;
    const Conditions tiltFaults =
        Condition::TransducerSilent | Condition::TransducerCrc | Condition::TransducerRange | Condition::TiltNotReady;
    const Conditions temperatureFaults =
        Condition::TemperatureReadError | Condition::TemperatureRange | Condition::TemperatureNotReady;
    quint16 flags = 0;
    if (!sensor.measuresTilt || !situation.hasTilt || (has & tiltFaults)) {
        flags |= TiltInvalid;
    }
    if (!sensor.measuresTemperature || !situation.hasTemperature || (has & temperatureFaults)) {
        flags |= TemperatureInvalid;
    }
    if (!sensor.measuresAcceleration || !situation.hasAcceleration) {
        flags |= AccelerationInvalid;
    }
    if (has.testFlag(Condition::RingOverrun)) {
        flags |= RingOverrun | AccelerationInvalid;
    }
    if (has.testFlag(Condition::SyncError)) {
        flags |= SyncError | AccelerationInvalid;
    }
    if (has.testFlag(Condition::Rebooted)) {
        flags |= Rebooted | allInvalid;
    }
    return flags;
}

quint16 thermostatFlags(const SensorConfig &sensor, const SensorSituation &situation)
{
    const double power = situation.heaterPower.value_or(0);
    if (sensor.hasThermostat && situation.heaterPower && power >= 99.9) {
        return HeaterAtMaximum | ThermostatUnsettled;
    }
    return sensor.hasThermostat && situation.heaterPower && power < 0.1 ? HeaterAtMinimum | ThermostatUnsettled : 0;
}

quint16 legacyFlags(const SensorConfig &sensor, const SensorSituation &situation)
{
    quint16 flags = situation.heaterPower.value_or(0) < 0.1 ? HeaterAtMinimum | ThermostatUnsettled : 0;
    if (sensor.type == SensorType::InD) {
        flags |= Rebooted;
    }
    return flags;
}

} // namespace

quint16 sensorWord(const SensorConfig &sensor, const SensorSituation &situation, const StatusRules &rules)
{
    if (!sensor.isOn) {
        return word(StatusCode::Good, NotPolled | allInvalid);
    }
    switch (situation.line) {
    case LineState::Off: return word(StatusCode::PortOff, allInvalid);
    case LineState::OpenFailed:
    case LineState::Lost: return word(StatusCode::PortError, allInvalid);
    case LineState::Opening:
    case LineState::Service:
    case LineState::Open: break;
    }
    if (situation.crcErrorsInRow >= rules.crcErrorLimit) {
        return word(StatusCode::CrcErrors, allInvalid);
    }
    if (situation.readErrorsInRow >= rules.readErrorLimit) {
        return word(StatusCode::NoAnswer, allInvalid);
    }
    if (!situation.hasAnswered || situation.line != LineState::Open) {
        return word(StatusCode::Good, allInvalid);
    }
    quint16 flags = validityFlags(sensor, situation) | thermostatFlags(sensor, situation);
    if (rules.hasLegacyBits) {
        flags |= legacyFlags(sensor, situation);
    }
    return word(conditionCode(sensor, situation.conditions), flags);
}

quint16 initialSensorWord(const LineConfig &line, const SensorConfig &sensor, const StatusRules &rules)
{
    SensorSituation situation;
    situation.line = line.isOn ? LineState::Opening : LineState::Off;
    return sensorWord(sensor, situation, rules);
}

int channelCode(LineState state)
{
    switch (state) {
    case LineState::OpenFailed: return 1;
    case LineState::Lost: return 2;
    case LineState::Off: return 3;
    case LineState::Opening:
    case LineState::Open:
    case LineState::Service: break;
    }
    return 0;
}

quint32 channelWord(const QList<LineStatus> &lines)
{
    quint32 word = 0;
    for (const LineStatus &line : lines) {
        if (line.port >= 1 && line.port <= 16) {
            word |= static_cast<quint32>(channelCode(line.state)) << (2 * (line.port - 1));
        }
    }
    return word;
}

} // namespace gorizont
