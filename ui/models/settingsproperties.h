#pragma once

#include "core/config/serverconfig.h"
#include "ui/models/property.h"

namespace gorizont {

/// The entries of the tab <Настройки> for what is selected (manual 000, sections 4.6 – 4.8). Values that the ini gave
/// and the program could not use are marked. Pure.
/// \a gateways: of OPC DA, connected now.
Properties serverSettings(const ServerConfig &config, int gateways = 0);
Properties lineSettings(const ServerConfig &config, const LineConfig &line);
Properties sensorSettings(const ServerConfig &config, const SensorConfig &sensor);

} // namespace gorizont
