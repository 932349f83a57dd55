#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/property.h"

namespace gorizont {

/// The rows of the page <Порт> in the order of manual 000, section 4.4.
Properties portProperties(const SensorRegistry::Line &line, SteadyTime now);

/// The rows of the page <Датчик> in the order of manual 000, section 4.5, as spec/gorizont.md, section 8, writes them.
Properties sensorProperties(const SensorRegistry::Sensor &sensor, LineState line, SteadyTime now);

} // namespace gorizont
