#pragma once

#include "core/devices/simulateddevice.h"
#include "core/values/sensorconfig.h"

#include <memory>

namespace gorizont::and3 {

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::and3
