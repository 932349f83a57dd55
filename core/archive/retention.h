#pragma once

#include "core/archive/archivestore.h"

namespace gorizont {

/// Removes what is older than \a retention says, and of what is too large the oldest readings and samples, then events,
/// then rollups. A few rows at a time, so that the commits in between are not late. Archive thread.
class Retention
{
public:
    static constexpr int mostRows = 300; ///< of one kind at a time

    explicit Retention(const ArchiveRetention &retention)
        : m_retention(retention)
    {
    }

    enum class Outcome : quint8 { Failed, Done, MoreToDo };
    Outcome sweep(ArchiveStore &store, UtcTime now);

private:
    bool sweepAge(ArchiveDatabase &database, UtcTime now);
    bool sweepSize(ArchiveDatabase &database);
    bool remove(ArchiveDatabase &database, const QString &rows, const QVariantList &values = {});

    const ArchiveRetention m_retention;
    bool m_hasMore = false;
};

/// Bytes of the file that hold something; PostgreSQL: of the tables, with the room of removed rows. 0: not known.
qint64 usedBytes(ArchiveDatabase &database);

} // namespace gorizont
