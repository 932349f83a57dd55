#include "core/archive/damagedfile.h"

#include "core/archive/archivebytes.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

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

QStringList copiesOf(const QString &path)
{
    const QFileInfo file(path);
    static const QRegularExpression stamp(QStringLiteral("^\\.damaged-\\d{8}-\\d{6}(-\\d+)?$"));
    QStringList copies;
    const QDir folder = file.dir();
    for (const QString &name : folder.entryList(QDir::Files, QDir::Name | QDir::Reversed)) {
        if (name.startsWith(file.fileName()) && stamp.match(name.mid(file.fileName().size())).hasMatch()) {
            copies.append(folder.filePath(name));
        }
    }
    return copies;
}

qint64 copyName(const QString &copy)
{
    return (qint64{1} << 32) | crc32(QFileInfo(copy).fileName().toUtf8());
}

} // namespace gorizont
