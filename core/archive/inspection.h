#pragma once

#include "core/archive/archiveconfig.h"

#include <QStringList>

#include <optional>

namespace gorizont {

/// What is in an archive, and what of it makes sense.
struct ArchiveReport
{
    qint64 bytes = 0; ///< of the file that hold something; PostgreSQL: of the tables
    qint64 chunks = 0; ///< readings at full rate and raw samples
    qint64 readings = 0; ///< in chunks
    qint64 samples = 0; ///< in chunks, of both axes one
    qint64 rollups = 0; ///< rows
    qint64 commits = 0; ///< rows of the tail: in no chunk yet
    qint64 events = 0;
    qint64 gaps = 0;
    qint64 records = 0;
    qint64 damaged = 0; ///< rows of all these that cannot be read
    QStringList problems; ///< what the database itself finds wrong
    bool isGood() const { return damaged == 0 && problems.isEmpty(); }
};

/// Reads every row and compares every check sum; a writer is not disturbed. Empty: \a error says why the archive cannot
/// be opened.
std::optional<ArchiveReport> inspectArchive(const ArchiveConfig &config, QString *error);

/// Only what is counted quickly: bytes and numbers of rows.
std::optional<ArchiveReport> countArchive(const ArchiveConfig &config, QString *error);

/// Copies an SQLite archive as it is at this moment to \a target, which must not exist; a writer goes on meanwhile. False:
/// \a error says why, and there is no \a target.
bool backUpArchive(const ArchiveConfig &config, const QString &target, QString *error);

} // namespace gorizont
