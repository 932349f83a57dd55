#pragma once

#include "core/config/serverconfig.h"
#include "ui/models/property.h"

namespace gorizont {

/// The last entries of the server: what is served to whom, and what is sent where. \a gateways: of OPC DA, connected now.
Properties networkSettings(const ServerConfig &config, int gateways);

} // namespace gorizont
