#pragma once

#include "core/archive/backfill.h"
#include "core/values/gap.h"
#include "core/values/journalentry.h"

#include <QByteArray>

#include <optional>

namespace gorizont {

/// What goes into the archive with one commit, and the bytes in which it waits for a server. Pure.
///
///     version 1 · time (signed µs UTC) · byte, start of the program (signed µs UTC) if it is 1 ·
///     TailBatch (piece; empty: no readings and blocks) ·
///     count · for each event: byte kind, time, port, number N (signed numbers), text (piece, UTF-8) ·
///     count · for each gap: number N, from, byte, to if it is 1, byte reason, source (piece, UTF-8)
///
/// Version 2 goes on, and stands where there are backfills:
///
///     count · for each of them: number N, source (piece, UTF-8), period (number, µs), TailBatch (piece, as above),
///     count of records · for each record: start (signed µs UTC), name (piece, UTF-8), data (piece)
struct ArchiveBatch
{
    UtcTime time; ///< of the commit
    std::optional<UtcTime> startedAt; ///< the program began then, and could not ask what was known before
    QList<KeptReading> readings;
    QList<SampleBlock> blocks;
    QList<JournalEntry> entries;
    QList<Gap> gaps;
    QList<Backfill> backfills;
    bool operator==(const ArchiveBatch &) const = default;

    QByteArray encode() const;
    /// Empty: \a bytes are damaged.
    static std::optional<ArchiveBatch> decode(QByteArrayView bytes);
};

} // namespace gorizont
