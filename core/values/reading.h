#pragma once

#include "core/values/timing.h"
#include "core/values/vibration.h"
#include "core/values/weather.h"

#include <QFlags>
#include <QList>
#include <QMetaType>

#include <optional>

namespace gorizont {

struct Tilt
{
    double x = 0; ///< arc-seconds
    double y = 0; ///< arc-seconds
    bool operator==(const Tilt &) const = default;
};

/// A horizontal shift along the axes of the site.
struct Displacement
{
    double x = 0; ///< mm
    double y = 0; ///< mm
    bool operator==(const Displacement &) const = default;
};

/// What the tilt of a sensor in a chain means there (spec/usm-isn.md, 13).
struct LinkDisplacement
{
    Displacement own; ///< of the upper end of its link over the lower one
    std::optional<Displacement> sum; ///< over the foot of the chain; empty: a sensor below is not valid
    bool operator==(const LinkDisplacement &) const = default;
};

/// How much a sensor trembled while it measured its tilt: mean absolute deviation along its own axes.
struct TiltVariation
{
    double x = 0; ///< degrees
    double y = 0; ///< degrees
    bool operator==(const TiltVariation &) const = default;
};

/// Accelerations of the last minute (manual 000, sections 4.3, 4.5, 10.4; spec/and3.md, Statistics), mm/s².
struct AccelStatistics
{
    double maximum = 0; ///< modulus of the largest vector (ax, ay)
    double maximumX = 0; ///< its components, signed
    double maximumY = 0;
    double direction = 0; ///< of the largest vector, degrees, 0 ≤ direction < 360
    double rms = 0; ///< of the modulus, about zero
    double rmsX = 0;
    double rmsY = 0;
    bool operator==(const AccelStatistics &) const = default;
};

/// How far the packets of an accelerometer's ring have been fetched. A packet holds 32 samples of both axes.
struct RingProgress
{
    quint64 packetsMeasured = 0; ///< by the sensor since its start
    quint64 packetsRead = 0; ///< fetched since the program started
    bool operator==(const RingProgress &) const = default;
};

/// What a device says of itself beside its values; every driver translates its own bits into these.
enum class Condition : quint16 {
    TiltNotReady = 1 << 0,
    TemperatureNotReady = 1 << 1,
    TransducerSilent = 1 << 2,
    TransducerCrc = 1 << 3,
    TransducerRange = 1 << 4,
    TemperatureReadError = 1 << 5,
    TemperatureRange = 1 << 6,
    FanError = 1 << 7,
    ThermostatError = 1 << 8,
    Rebooted = 1 << 9, ///< since the last acknowledgement
    RingOverrun = 1 << 10, ///< samples were lost before they could be read
    SyncError = 1 << 11, ///< two packets do not follow each other
};
Q_DECLARE_FLAGS(Conditions, Condition)
Q_DECLARE_OPERATORS_FOR_FLAGS(Conditions)

/// What one turn of a driver reads, in the axes of the device and without any correction.
struct Measurement
{
    std::optional<Tilt> tilt;
    std::optional<TiltVariation> variation;
    std::optional<double> temperature; ///< °C
    std::optional<double> heaterPower; ///< %
    std::optional<double> fanFrequency; ///< 1/s
    std::optional<quint16> rawStatus; ///< the device's own word
    std::optional<quint16> rawMode; ///< the device's own word
    std::optional<RingProgress> ring;
    std::optional<Vibration> vibration;
    std::optional<Weather> weather;
    Conditions conditions;
    bool operator==(const Measurement &) const = default;
};

struct SensorCounters
{
    quint64 answers = 0;
    quint64 readErrors = 0;
    quint64 crcErrors = 0;
    bool operator==(const SensorCounters &) const = default;
};

/// The state of one sensor after a turn or after a change of its line. Values are the last known ones, corrected by the
/// sensor's offsets and axes (spec/gorizont.md, section 2); the status word says which of them are valid now.
/// No member owns memory but the lists of a vibration module and of a weather station, which copies share, so that thousands
/// of readings a second are copied for little.
struct Reading
{
    int number = 0; ///< N, the sensor
    UtcTime time; ///< of this reading
    bool isAnswer = false; ///< the sensor answered just now; otherwise only the state changed
    quint16 status = 0; ///< manual 000, section 11.2
    std::optional<SteadyTime> answeredAt; ///< when the values below were measured; empty: never

    std::optional<Tilt> tilt;
    std::optional<TiltVariation> variation; ///< of the tilt above, along the axes of the device
    std::optional<double> temperature; ///< °C
    std::optional<double> heaterPower; ///< %
    std::optional<double> fanFrequency; ///< 1/s
    std::optional<AccelStatistics> acceleration;
    std::optional<LinkDisplacement> displacement; ///< of a sensor in a chain whose tilt is valid
    std::optional<quint16> rawStatus;
    std::optional<quint16> rawMode;
    std::optional<RingProgress> ring;
    std::optional<Vibration> vibration; ///< of a vibration module
    std::optional<Weather> weather; ///< of a weather station

    SensorCounters counters;
    std::chrono::microseconds period{0}; ///< between the last two turns; 0: fewer than two so far
    std::chrono::microseconds exchange{0}; ///< how long the last turn took

    bool operator==(const Reading &) const = default;
};

using Readings = QList<Reading>;

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::Reading)
