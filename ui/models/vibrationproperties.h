#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/property.h"

namespace gorizont {

/// The rows of the page <Датчик> that only a vibration module has: its channels with their measurements, its relays. None for a
/// sensor of another type, and for a module that has not answered yet.
Properties vibrationProperties(const SensorRegistry::Sensor &sensor);

/// Its channels, a line each, for tool tips; empty for a sensor of another type, and for a module that does not answer.
QString vibrationSummary(const Reading &reading);

} // namespace gorizont
