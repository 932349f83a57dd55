#pragma once

#include "core/values/timing.h"

#include <QStringList>

#include <optional>

namespace gorizont {

/// Renames the SQLite file \a path and what belongs to it to `path.damaged-20240131-235959` (UTC), which it returns;
/// empty: it could not be renamed. Nobody may have it open.
std::optional<QString> setAside(const QString &path, UtcTime now);

/// What was set aside for \a path and is still there, the last one first.
QStringList copiesOf(const QString &path);

/// A number by which a copy is known again; never 0.
qint64 copyName(const QString &copy);

} // namespace gorizont
