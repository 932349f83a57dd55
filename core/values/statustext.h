#pragma once

#include "core/values/lineconfig.h"
#include "core/values/linestatus.h"
#include "core/values/statusword.h"

#include <QString>

namespace gorizont {

/// What a critical code means, as a sentence without a full stop in the language of the program.
QString statusText(StatusCode code);

/// The same for the state of a port.
QString lineStateText(LineState state);

/// `АН-Д3 № 1 (COM10, address 1)`: how journal and messages name a sensor.
QString sensorTitle(const SensorConfig &sensor, const LineConfig &line);

} // namespace gorizont
