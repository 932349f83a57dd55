#pragma once

#include <QString>

namespace gorizont {

/// Writes \a bytes as the file \a path: the whole of it, or what was there stays. Returns why not: file and reason; empty: it
/// is written. Keeps no state: for any thread.
QString writeWholeFile(const QString &path, const QByteArray &bytes);

} // namespace gorizont
