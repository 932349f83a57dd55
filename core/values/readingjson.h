#pragma once

#include "core/values/lineconfig.h"
#include "core/values/reading.h"

#include <QByteArray>
#include <QString>

namespace gorizont {

/// A reading as one line of JSON without a line end, UTF-8: the form of `--print-readings` and of everything else that
/// sends readings as text. Keys: `time` (ISO 8601, UTC, ms), `number`, `name`, `type`, `port` (`COM4`), `address`,
/// `status`, and of what is valid in this reading `tiltX`, `tiltY` (arc-seconds), `temperature` (°C), `heaterPower` (%),
/// `fanFrequency` (1/s), `accelMax`, `accelRmsX`, `accelRmsY` (mm/s²), `accelDirection` (degrees), `linkX`, `linkY`
/// (mm, of the sensor's link of a chain), `displacementX`, `displacementY` (mm, over the foot of the chain),
/// `rawStatus`, and of a vibration module `channels` and `relays` (core/values/vibrationjson), of a weather station `digital`,
/// `parameters` and `events` (core/values/weatherjson).
QByteArray readingToJson(const Reading &reading, const SensorConfig &sensor, const LineConfig &line);

/// ISO 8601, UTC, ms: `2018-02-07T15:33:03.250Z`.
QString isoTime(UtcTime time);

} // namespace gorizont
