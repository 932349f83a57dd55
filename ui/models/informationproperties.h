#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/property.h"

namespace gorizont {

/// The rows below those of the manual on the page <Датчик>: what the sensor says of itself when CanInfo=1. None for a
/// sensor of a type that is not asked.
Properties informationProperties(const SensorRegistry::Sensor &sensor);

} // namespace gorizont
