#pragma once

#include "core/devices/simulateddevice.h"
#include "core/values/sensorconfig.h"

#include <memory>

namespace gorizont::ind3 {

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::ind3
