#pragma once

#include "core/values/reading.h"
#include "core/values/sensorconfig.h"

#include <QList>

namespace gorizont {

/// What can be kept of a sensor over time. The numbers stand in archives: they are never given a second meaning.
enum class Quantity : quint8 {
    TiltX = 1, ///< arc-seconds
    TiltY = 2, ///< arc-seconds
    Temperature = 3, ///< °C
    HeaterPower = 4, ///< %
    FanFrequency = 5, ///< 1/s
    AccelMaximum = 6, ///< mm/s², and the five below
    AccelMaximumX = 7,
    AccelMaximumY = 8,
    AccelRms = 9,
    AccelRmsX = 10,
    AccelRmsY = 11,
    AccelDirection = 12, ///< degrees
    SampleX = 13, ///< mm/s², of the raw stream of an accelerometer
    SampleY = 14, ///< mm/s²
    DisplacementX = 15, ///< mm, over the foot of the chain
    DisplacementY = 16, ///< mm
    WindSpeed = 17, ///< m/s, mean of the station
    /// Degrees, 0 ≤ direction < 360, mean of the station. Buckets take it as any number: where the wind turns through the north their
    /// mean says nothing, minimum and maximum are near 0 and 360; single readings are always right.
    WindDirection = 18,
    WindMaximum = 19, ///< m/s, of the last turns
    Pressure = 20, ///< mm Hg
    Humidity = 21, ///< %
};

/// Every quantity a reading can carry, in the order of the numbers; samples are not among them.
const QList<Quantity> &readingQuantities();

/// What an answer says of \a quantity; empty: absent, or not valid by the status word.
std::optional<double> valueOf(const Reading &reading, Quantity quantity);

/// The quantities that \a sensor has by its configuration: what it measures, and what its chain makes of that.
QList<Quantity> quantitiesOf(const SensorConfig &sensor);

} // namespace gorizont
