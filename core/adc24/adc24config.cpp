#include "core/adc24/adc24config.h"

#include "core/values/statusword.h"

namespace gorizont {

namespace {

struct Candidate
{
    const LineConfig *line = nullptr;
    const SensorConfig *sensor = nullptr;

    bool isPolled() const { return line->isOn && sensor->isOn; }

    /// What is off has no samples, so the first of those polled goes before the first of all.
    bool goesBefore(const Candidate &other) const
    {
        return isPolled() != other.isPolled() ? isPolled() : sensor->number < other.sensor->number;
    }
};

/// The one that is asked for, else the first.
std::optional<Candidate> chooseSensor(const ServerConfig &config)
{
    std::optional<Candidate> chosen;
    for (const LineConfig &line : config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            const Candidate candidate{&line, &sensor};
            if (!sensor.measuresAcceleration) {
                continue;
            }
            if (sensor.number == config.adc24Sensor) {
                return candidate;
            }
            if (!chosen || candidate.goesBefore(*chosen)) {
                chosen = candidate;
            }
        }
    }
    return chosen;
}

} // namespace

std::optional<Adc24Config> adc24Config(const ServerConfig &config)
{
    const std::optional<Candidate> chosen = chooseSensor(config);
    if (!config.servesAdc24 || !chosen) {
        return std::nullopt;
    }
    const StatusRules rules{config.timing.readErrorLimit, config.timing.crcErrorLimit, config.hasLegacyStatusBits};
    Adc24Config adc24;
    adc24.port = config.adc24Port;
    adc24.number = chosen->sensor->number;
    adc24.axis = config.adc24Axis;
    adc24.ringPackets = config.ringPackets;
    adc24.initialWord = initialSensorWord(*chosen->line, *chosen->sensor, rules);
    adc24.desk.clients = config.modbusClients;
    adc24.desk.idle = config.modbusIdle;
    adc24.desk.bind = config.modbusBind;
    adc24.desk.allow = config.modbusAllow;
    return adc24;
}

} // namespace gorizont
