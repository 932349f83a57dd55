#pragma once

#include "core/values/lineconfig.h"
#include "core/values/statusword.h"

#include <QString>

namespace gorizont {

/// What a critical code means, in the language of the program: for tables, journal and messages.
QString statusText(StatusCode code);
/// What a device says itself of the critical code of \a reading: a vibration module which lines to its sensors are shorted or broken, a
/// weather station that its supply is bad. Empty: no more than the code.
QString causeText(const Reading &reading);
/// That cause, or the meaning of the code.
QString statusText(const Reading &reading);

/// `АН-Д3 № 1 (COM10, address 1)`: how journal and messages name a sensor.
QString sensorTitle(const SensorConfig &sensor, const LineConfig &line);

} // namespace gorizont
