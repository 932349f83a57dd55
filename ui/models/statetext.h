#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/health.h"

#include <QString>

namespace gorizont {

/// States as sentences in the language of the program, for tables, tool tips and messages. Pure.
namespace statetext {

QString line(LineState state);
QString sensor(const SensorRegistry::Sensor &sensor, LineState line);
QString health(Health health);

/// `1 АН-Д3 [place] [address]`: the name of a sensor in the tree and in tables. Without a place its brackets are left
/// out; a sensor of no known type is called by its name.
QString sensorTitle(const SensorConfig &sensor);

QString counts(const HealthCounts &counts); ///< one line for the status bar and the tray
QString yesNo(bool isYes);

} // namespace statetext

} // namespace gorizont
