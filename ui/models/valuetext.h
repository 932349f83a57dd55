#pragma once

#include "core/values/reading.h"
#include "core/values/sensorconfig.h"

#include <QString>

namespace gorizont {

/// How values are written on the screens (spec/gorizont.md, sections 2, 3 and 8). Pure. The decimal mark is always a
/// point, so that what is copied reads the same everywhere.
namespace valuetext {

using Seconds = std::chrono::seconds;

QString absent(); ///< `—`: the only way to show a value that is not there or not valid

QString orAbsent(const QString &text);

QString fixed(std::optional<double> value, int decimals); ///< `21.38`
QString signedFixed(std::optional<double> value, int decimals); ///< `+0.756`
QString degrees(std::optional<double> arcSeconds); ///< `-1.000`
QString degreesAndArcSeconds(double arcSeconds); ///< `+0.028 (+100.0)`

QString tilt(const std::optional<Tilt> &tilt); ///< `-1.000 +0.756 (-3599.5 +2720.5)`

/// `7.67 270.0 (2.19|0.00 2.19) 179:179 (5728) 179` = modulus of the maximum, its direction, (RMS of the modulus | X
/// Y), packets in the sensor : read (samples) saved.
QString acceleration(
    const std::optional<AccelStatistics> &statistics, const std::optional<RingProgress> &ring, quint64 saved);

QString thermostat(std::optional<double> heaterPower, std::optional<double> fanFrequency); ///< `45.3 (41.0)`
QString poll(const Reading &reading, SteadyTime now); ///< `1.002|0.031|00:00` = period | exchange | age

QString duration(std::chrono::nanoseconds elapsed); ///< `0:03:58`
QString age(std::chrono::nanoseconds elapsed); ///< `03:58`, from an hour on `1:03:58`

QString binary(quint16 word); ///< `0010 0100 0000 1111`, most significant bit first
QString words(std::optional<quint16> status, std::optional<quint16> mode); ///< both in binary with ` : ` between
QString status(quint16 word); ///< `10 0000 0001 0100`: the code in decimal, width 2, the other bits in binary

QString clock(UtcTime time); ///< `hh:mm:ss dd.mm.yy`, local time

} // namespace valuetext

/// Only what is valid now; everything else is absent on the screens.
std::optional<Tilt> validTilt(const Reading &reading);
std::optional<double> validTemperature(const Reading &reading);
std::optional<AccelStatistics> validAcceleration(const Reading &reading);
/// Fan and heater have no flag of their own: they count while the sensor is polled and answers. A sensor whose name
/// tells of no thermostat and that reports zero has none.
std::optional<double> validHeaterPower(const SensorConfig &sensor, const Reading &reading);
std::optional<double> validFanFrequency(const SensorConfig &sensor, const Reading &reading);
/// The module answers. What of it is valid, channels and measurements say themselves.
std::optional<Vibration> validVibration(const Reading &reading);

} // namespace gorizont
