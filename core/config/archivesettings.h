#pragma once

#include <QString>

namespace gorizont {

enum class ArchiveDriver : quint8 { Sqlite, PostgreSql };

/// [Archive] of the ini: where every reading is kept, and for how long.
struct ArchiveSettings
{
    bool isOn = true; ///< On
    ArchiveDriver driver = ArchiveDriver::Sqlite; ///< Driver: QSQLITE, QPSQL
    QString file; ///< File, SQLite; empty: `History/archive.sqlite` of the data folder, from which it is counted
    QString host; ///< Host, PostgreSQL, and so on below
    int port = 5432; ///< Port
    QString database; ///< Database
    QString user; ///< User
    QString passwordFile; ///< PasswordFile: its first line is the password
    QString site = QStringLiteral("gorizont"); ///< Site: the schema of this site in the database
    int keepRaw = 0; ///< KeepRaw: days of readings at full rate; 0: for ever, and so on below
    int keepSamples = 0; ///< KeepSamples: days of raw samples of accelerometers
    int keepRollups = 0; ///< KeepRollups: days of minutes, hours and days; at least KeepRaw
    int keepEvents = 0; ///< KeepEvents: days of events and gaps
    int mostSize = 0; ///< MostSize: MB of the file, only SQLite; 0: any size

    bool operator==(const ArchiveSettings &) const = default;
};

} // namespace gorizont
