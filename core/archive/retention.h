#pragma once

#include "core/archive/archivestore.h"

namespace gorizont {

/// Removes what is older than \a retention says, and of what is too large the oldest readings and samples, then events,
/// then rollups. A few rows at a time, so that the commits in between are not late. Archive thread.
class Retention
{
public:
    static constexpr int mostRows = 300; ///< of one kind at a time
    static constexpr qint64 mostPages = 600; ///< of the file that are given back at a time

    explicit Retention(const ArchiveRetention &retention)
        : m_retention(retention)
    {
    }

    enum class Outcome : quint8 { Failed, Done, MoreToDo };
    enum class Room : quint8 {
        GivenBack, ///< to the disk: the file becomes smaller
        Kept, ///< for what is written next
    };
    Outcome sweep(ArchiveStore &store, UtcTime now, Room room = Room::GivenBack);

private:
    bool sweepAge(ArchiveDatabase &database, UtcTime now);
    bool sweepSize(ArchiveDatabase &database);
    bool shrink(ArchiveDatabase &database);
    bool remove(ArchiveDatabase &database, const QString &rows, const QVariantList &values = {});

    const ArchiveRetention m_retention;
    bool m_hasMore = false;
};

/// Bytes of the file that hold something; PostgreSQL: of the tables, with the room of removed rows. 0: not known.
qint64 usedBytes(ArchiveDatabase &database);

/// The rows of \a kind that end before a time, `chunk WHERE …`, found by an index. Its places: that time, for chunks twice;
/// for rollups less stretchOf().
QString expiredRows(ChunkKind kind);

} // namespace gorizont
