#pragma once

#include "core/config/serverconfig.h"

#include <optional>

namespace gorizont {

/// Reads the ini at \a path. Empty when the file cannot be read; \a why is then the system's reason.
std::optional<ConfigReading> readConfigFile(const QString &path, QString *why);

} // namespace gorizont
