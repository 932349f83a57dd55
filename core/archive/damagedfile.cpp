#include "core/archive/damagedfile.h"

#include <QDateTime>
#include <QFile>

namespace gorizont {

std::optional<QString> setAside(const QString &path, UtcTime now)
{
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(now.time_since_epoch()).count();
    const QString stamp = QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).toString(QStringLiteral("yyyyMMdd-HHmmss"));
    const QString stem = QStringLiteral("%1.damaged-%2").arg(path, stamp);
    QString aside = stem;
    for (int copy = 2; QFile::exists(aside); ++copy) {
        aside = QStringLiteral("%1-%2").arg(stem).arg(copy);
    }
    if (!QFile::rename(path, aside)) {
        return {};
    }
    // The log belongs to that file and no other: it must not be found beside a new one.
    QFile::rename(path + QStringLiteral("-wal"), aside + QStringLiteral("-wal"));
    QFile::remove(path + QStringLiteral("-shm"));
    return aside;
}

} // namespace gorizont
