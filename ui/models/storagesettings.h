#pragma once

#include "core/config/serverconfig.h"
#include "ui/models/property.h"

namespace gorizont {

/// The entries of the server about the archive and the chains of sensors.
Properties storageSettings(const ServerConfig &config);

} // namespace gorizont
