#pragma once

#include "core/archive/archivestore.h"
#include "core/archive/readingchunk.h"
#include "core/archive/rollupbook.h"
#include "core/archive/tailbatch.h"

namespace gorizont {

/// Takes over what can be read of a damaged SQLite archive, a few rows at a time. Chunks and rollups count only if their
/// check sums are right; where rows cannot be read those behind them are tried. Archive thread.
class Salvage
{
public:
    /// \a from: where it goes on. Its tail is not wanted where the writer still has it.
    Salvage(const QString &file, const ArchiveConfig &config, const SalvageMark &from);

    enum class Outcome : quint8 { Failed, Done, MoreToDo };
    /// Within a transaction of \a store. Failed: that store could not be written; the same step is tried again.
    Outcome step(ArchiveStore &store, RollupBook &rollups);
    /// The last step was not committed.
    void undo();

    SalvageMark mark() const; ///< after the last step
    QHash<int, UtcTime> knownFrom() const { return m_knownFrom; } ///< of the rows so far: N → the first reading

private:
    struct Position
    {
        int table = 0;
        qint64 last = 0; ///< id
        qint64 stride = 1; ///< by how much a part that cannot be read is stepped over
        int rows = 0; ///< to read at a time
    };

    bool takeRow(const QSqlQuery &row, ArchiveStore &store, RollupBook &rollups);
    bool takeChunk(const QSqlQuery &row, ArchiveStore &store);
    bool takeRollup(const QSqlQuery &row, RollupBook &rollups);
    bool takeTail(const QSqlQuery &row, ArchiveStore &store, RollupBook &rollups);
    bool takeKnown();
    void stepOver();
    qint64 lastId();

    ArchiveDatabase m_database;
    const SalvageMark m_from;
    Position m_position;
    Position m_before; ///< the last step
    QHash<int, ValueOffsets> m_offsets; ///< by N
    QHash<int, KnownSensor> m_known; ///< of the damaged file
    QHash<int, UtcTime> m_knownFrom;
    qint64 m_rescued = 0; ///< rows
    qint64 m_rescuedBefore = 0;
};

} // namespace gorizont
