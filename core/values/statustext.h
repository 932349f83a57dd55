#pragma once

#include "core/values/lineconfig.h"
#include "core/values/statusword.h"

#include <QString>

namespace gorizont {

/// What a critical code means, in the language of the program: for tables, journal and messages.
QString statusText(StatusCode code);
/// The critical code of \a reading; of a vibration module without a sensor that works: which lines are shorted or broken.
QString statusText(const Reading &reading);

/// `АН-Д3 № 1 (COM10, address 1)`: how journal and messages name a sensor.
QString sensorTitle(const SensorConfig &sensor, const LineConfig &line);

} // namespace gorizont
