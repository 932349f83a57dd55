#pragma once

#include "core/archive/archivestore.h"
#include "core/archive/rollup.h"
#include "core/archive/samplechunk.h"

#include <map>
#include <utility>

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

    /// Stored ones that could not be read and were made again, since the last call.
    int takeDamaged() { return std::exchange(m_damaged, 0); }

    /// What is remembered may not be in the store: the transaction was not committed.
    void forget()
    {
        m_last.clear();
        m_damaged = 0;
    }

private:
    struct Stretch
    {
        UtcTime start;
        Buckets buckets;
    };

    bool addAll(const SeriesKey &key, const std::vector<UtcTime> &times, const ValueColumn &column, double offset);
    bool addToStretch(ChunkKind kind, const SeriesKey &key, UtcTime start, const Buckets &buckets, double offset);
    bool replaceStretch(ChunkKind kind, const SeriesKey &key, UtcTime start, const Buckets &buckets, double offset);
    std::optional<Buckets> rebuilt(ChunkKind kind, const SeriesKey &key, UtcTime start);
    std::optional<Buckets> fromRollups(ChunkKind kind, const SeriesKey &key, const TimeSpan &span);
    std::optional<Buckets> fromChunks(const SeriesKey &key, const TimeSpan &span);

    ArchiveStore &m_store;
    std::map<std::pair<ChunkKind, SeriesKey>, Stretch> m_last;
    int m_damaged = 0;
};

/// The samples of one axis as values, mm/s².
ValueColumn columnOf(const SampleChunk &chunk, Quantity axis);

} // namespace gorizont
