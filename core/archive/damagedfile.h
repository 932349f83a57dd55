#pragma once

#include "core/values/timing.h"

#include <QString>

#include <optional>

namespace gorizont {

/// Renames the SQLite file \a path and what belongs to it to `path.damaged-20240131-235959` (UTC), which it returns;
/// empty: it could not be renamed. Nobody may have it open.
std::optional<QString> setAside(const QString &path, UtcTime now);

} // namespace gorizont
