#pragma once

#include "core/devices/driver.h"
#include "core/devices/simulateddevice.h"

#include <memory>

namespace gorizont {

/// The driver for a sensor, by its type and its own options. Empty when no driver knows the type.
std::unique_ptr<Driver> makeDriver(DriverSettings settings);

/// A device that answers like \a sensor. Empty when the type has no simulator.
std::unique_ptr<SimulatedDevice> makeSimulatedDevice(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont
