#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/property.h"

namespace gorizont {

struct WindCounts;

/// The rows of the page <Датчик> that only a weather station has: a row a parameter, the digital inputs. None for a sensor of
/// another type, and for a station that has not answered yet; `—` for one that does not answer any more.
Properties weatherProperties(const SensorRegistry::Sensor &sensor, LineState line);

/// The wind as numbers: by the last answer \a weather (null: nothing to believe) and by \a counts of the readings before it.
Properties windProperties(const Weather *weather, const WindCounts &counts);

/// «Скорость ветра U, V» of the page <Датчик>: `+1.2 -3.4`, see WindComponents; `—` for a sensor that measures no wind.
QString windComponents(const SensorRegistry::Sensor &sensor, LineState line);

/// `wind 4.1 m/s, 225° SW; temperature …` in a line for tool tips; empty for a sensor of another type, and for a station that
/// does not answer.
QString weatherSummary(const SensorRegistry::Sensor &sensor, LineState line);

} // namespace gorizont
