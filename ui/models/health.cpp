#include "ui/models/health.h"

#include <algorithm>

namespace gorizont {

namespace {

using namespace statusbit;

/// A channel in use without a value, or a value that the module complains of.
bool hasTroubledChannel(const Vibration &vibration)
{
    return std::any_of(vibration.channels.begin(), vibration.channels.end(), [](const VibrationChannel &channel) {
        return channel.isEnabled && (channel.state != ChannelState::Good || channel.isAnythingRaised());
    });
}

/// Answering, and something it should measure cannot be used now.
bool lacksValues(const SensorConfig &sensor, const Reading &reading)
{
    const quint16 status = reading.status;
    return (sensor.measuresTilt && !isTiltValid(status)) || (sensor.measuresTemperature && !isTemperatureValid(status))
        || (sensor.measuresAcceleration && !isAccelerationValid(status))
        || (sensor.hasThermostat && (status & ThermostatUnsettled))
        || (reading.vibration && hasTroubledChannel(*reading.vibration));
}

/// A weather station may have no thermometer, and lacks nothing then.
bool isStationWithoutThermometer(const Reading &reading)
{
    return reading.weather && !reading.weather->parameters.isEmpty()
        && !reading.weather->find(weathercode::temperature);
}

} // namespace

Health lineHealth(LineState state)
{
    switch (state) {
    case LineState::Off: return Health::Off;
    case LineState::Opening: return Health::Unknown;
    case LineState::Open: return Health::Good;
    case LineState::OpenFailed:
    case LineState::Lost: return Health::Error;
    case LineState::Service: return Health::Service;
    }
    return Health::Unknown;
}

Health sensorHealth(const SensorRegistry::Sensor &sensor, LineState line)
{
    const quint16 status = sensor.reading.status;
    if ((status & NotPolled) || statusCode(status) == StatusCode::PortOff) {
        return Health::Off;
    }
    if (line == LineState::Service) {
        return Health::Service;
    }
    if (isCritical(status)) {
        return Health::Error;
    }
    if (sensor.reading.answeredAt && isStationWithoutThermometer(sensor.reading)) {
        return Health::Good;
    }
    if (!sensor.reading.answeredAt) {
        return Health::Unknown;
    }
    return lacksValues(sensor.config, sensor.reading) ? Health::Warning : Health::Good;
}

Health portHealth(LineState state, Health worstSensor)
{
    const Health own = lineHealth(state);
    return own == Health::Good && worstSensor >= Health::Warning ? Health::Warning : own;
}

bool isCritical(quint16 status)
{
    return statusCode(status) >= StatusCode::PortError;
}

HealthCounts countHealth(const SensorRegistry &registry)
{
    HealthCounts counts;
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        const LineState line = registry.lines()[static_cast<std::size_t>(sensor.line)].status.state;
        ++counts.sensors[static_cast<std::size_t>(sensorHealth(sensor, line))];
    }
    return counts;
}

Health siteHealth(const SensorRegistry &registry)
{
    Health worst = Health::Off;
    for (const SensorRegistry::Line &line : registry.lines()) {
        Health worstSensor = Health::Off;
        for (const int index : line.sensors) {
            const SensorRegistry::Sensor &sensor = registry.sensors()[static_cast<std::size_t>(index)];
            worstSensor = std::max(worstSensor, sensorHealth(sensor, line.status.state));
        }
        worst = std::max(worst, portHealth(line.status.state, worstSensor));
    }
    return worst;
}

} // namespace gorizont
