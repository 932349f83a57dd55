#include "core/archive/archiveconfig.h"

#include "core/config/serverconfig.h"

#include <QDir>
#include <QFile>

namespace gorizont {

namespace {

/// Empty: there is none, or it cannot be read; the server says so then.
QString passwordIn(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readLine()).trimmed() : QString();
}

std::chrono::hours daysOf(int count)
{
    return std::chrono::hours(24) * count;
}

} // namespace

ArchiveConfig archiveConfig(const ServerConfig &config, const QString &dataFolder)
{
    constexpr qint64 megabyte = 1'000'000;
    const ArchiveSettings &settings = config.archive;
    const QDir folder(dataFolder);
    ArchiveConfig archive;
    archive.driver = settings.driver;
    archive.file = folder.absoluteFilePath(
        settings.file.isEmpty() ? QStringLiteral("History/archive.sqlite") : QDir::fromNativeSeparators(settings.file));
    archive.host = settings.host;
    archive.port = settings.port;
    archive.database = settings.database;
    archive.user = settings.user;
    archive.site = settings.site;
    if (!settings.passwordFile.isEmpty()) {
        archive.password = passwordIn(folder.absoluteFilePath(QDir::fromNativeSeparators(settings.passwordFile)));
    }
    archive.lines = config.lines;
    archive.retention.readings = daysOf(settings.keepRaw);
    archive.retention.samples = daysOf(settings.keepSamples);
    archive.retention.rollups = daysOf(settings.keepRollups);
    archive.retention.events = daysOf(settings.keepEvents);
    archive.retention.mostBytes = settings.mostSize * megabyte;
    return archive;
}

} // namespace gorizont
