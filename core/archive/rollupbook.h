#pragma once

#include "core/archive/archivestore.h"
#include "core/archive/rollup.h"
#include "core/archive/samplechunk.h"

#include <map>

namespace gorizont {

/// Keeps the rollups of all curves up: joins the buckets of chunks to those that are stored. Remembers the last stretch
/// of every curve, so that it is not read back each time. Archive thread.
class RollupBook
{
public:
    explicit RollupBook(ArchiveStore &store)
        : m_store(store)
    {
    }

    /// Within a transaction; false: the store failed.
    bool add(int number, const ReadingChunk &chunk, const ValueOffsets &offsets);
    bool add(int number, const SampleChunk &chunk);
    /// \a buckets of one curve, of \a kind.
    bool add(ChunkKind kind, const SeriesKey &key, const Buckets &buckets, double offset);

    /// What is remembered may not be in the store: the transaction was not committed.
    void forget() { m_last.clear(); }

private:
    struct Stretch
    {
        UtcTime start;
        Buckets buckets;
    };

    bool addAll(const SeriesKey &key, const std::vector<UtcTime> &times, const ValueColumn &column, double offset);
    bool addToStretch(ChunkKind kind, const SeriesKey &key, UtcTime start, const Buckets &buckets, double offset);

    ArchiveStore &m_store;
    std::map<std::pair<ChunkKind, SeriesKey>, Stretch> m_last;
};

/// The samples of one axis as values, mm/s².
ValueColumn columnOf(const SampleChunk &chunk, Quantity axis);

} // namespace gorizont
