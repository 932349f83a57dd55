#pragma once

#include "core/config/archivesettings.h"
#include "core/values/lineconfig.h"

#include <chrono>

namespace gorizont {

/// How long each kind of data is kept; 0: for ever.
struct ArchiveRetention
{
    std::chrono::hours readings{0}; ///< at full rate
    std::chrono::hours samples{0}; ///< raw ones of accelerometers
    std::chrono::hours rollups{0}; ///< minutes, hours, days
    std::chrono::hours events{0}; ///< and gaps
    /// SQLite: of the whole file: the oldest readings and samples go first, rollups last; 0: any size. A server keeps the
    /// room of what was removed, so that its size says nothing of what is in it.
    qint64 mostBytes = 0;
};

/// What the archive has to know of the ini.
struct ArchiveConfig
{
    ArchiveDriver driver = ArchiveDriver::Sqlite;
    QString file; ///< SQLite: the file; its folder is created when needed. PostgreSQL: see spoolFile()
    QString host; ///< PostgreSQL: name or address
    int port = 5432; ///< PostgreSQL
    QString database; ///< PostgreSQL
    QString user; ///< PostgreSQL
    QString password; ///< PostgreSQL
    QString site; ///< PostgreSQL: the schema in which the tables of this site are
    QList<LineConfig> lines;
    qint64 mostSpoolBytes = qint64{2} << 30; ///< PostgreSQL: of the file that bridges a server that is gone
    ArchiveRetention retention;
    std::chrono::milliseconds commitInterval{800}; ///< what a kill can lose
    std::chrono::milliseconds retryInterval{3000}; ///< after a failure the store is asked this often
    std::chrono::milliseconds retentionInterval{600'000};
};

/// PostgreSQL: where what is measured waits for a server that is gone, beside \a file; empty: there is no such file.
QString spoolFile(const ArchiveConfig &config);

struct ServerConfig;

/// What [Archive] says; a file and a password file that are relative are those of \a dataFolder.
ArchiveConfig archiveConfig(const ServerConfig &config, const QString &dataFolder);

} // namespace gorizont
