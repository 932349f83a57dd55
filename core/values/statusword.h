#pragma once

#include "core/values/lineconfig.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"

namespace gorizont {

/// The two status words of manual 000, section 11, decided in spec/gorizont.md, section 5. This is the only place where
/// states and faults become codes.
namespace statusbit {
constexpr quint16 NotPolled = 1 << 11;
constexpr quint16 TiltInvalid = 1 << 10;
constexpr quint16 TemperatureInvalid = 1 << 9;
constexpr quint16 AccelerationInvalid = 1 << 8;
constexpr quint16 RingOverrun = 1 << 7;
constexpr quint16 SyncError = 1 << 6;
constexpr quint16 Rebooted = 1 << 5;
constexpr quint16 ThermostatUnsettled = 1 << 4;
constexpr quint16 HeaterAtMinimum = 1 << 3;
constexpr quint16 HeaterAtMaximum = 1 << 2;
} // namespace statusbit

/// The critical code in bits 15…12.
enum class StatusCode : quint8 {
    Good = 0,
    PortOff = 1,
    PortError = 2,
    NoAnswer = 3,
    CrcErrors = 4,
    TransducerSilent = 5,
    TransducerCrc = 6,
    TransducerRange = 7,
    TemperatureSensor = 8,
    TemperatureRange = 9,
    Fan = 10,
    Thermostat = 11,
};

/// Everything that decides the word of one sensor.
struct SensorSituation
{
    LineState line = LineState::Opening;
    bool hasAnswered = false; ///< since the line was last opened
    int readErrorsInRow = 0;
    int crcErrorsInRow = 0;
    Conditions conditions; ///< of the last good answer
    std::optional<double> heaterPower; ///< %, of the last good answer
    bool hasTilt = false; ///< the last good answer brought it
    bool hasTemperature = false;
    bool hasAcceleration = false; ///< the statistics are ready
};

struct StatusRules
{
    int readErrorLimit = 10; ///< NumRErrSrs
    int crcErrorLimit = 10; ///< NumCErrSrs
    bool hasLegacyBits = false; ///< LegacyStatusBits=1: what the original program printed
    bool operator==(const StatusRules &) const = default;
};

quint16 sensorWord(const SensorConfig &sensor, const SensorSituation &situation, const StatusRules &rules);

/// What the word is before anything was tried.
quint16 initialSensorWord(const LineConfig &line, const SensorConfig &sensor, const StatusRules &rules);

inline StatusCode statusCode(quint16 word)
{
    return static_cast<StatusCode>(word >> 12);
}
inline bool isTiltValid(quint16 word)
{
    return !(word & statusbit::TiltInvalid);
}
inline bool isTemperatureValid(quint16 word)
{
    return !(word & statusbit::TemperatureInvalid);
}
inline bool isAccelerationValid(quint16 word)
{
    return !(word & statusbit::AccelerationInvalid);
}

/// The two bits of one port in the channel word: 0 no errors or service, 1 cannot be opened, 2 write errors, 3 off.
int channelCode(LineState state);

/// The channel word: port i in bits 2(i−1)…; a slot without a port is 0.
quint32 channelWord(const QList<LineStatus> &lines);

} // namespace gorizont
