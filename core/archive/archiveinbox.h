#pragma once

#include "core/archive/backfill.h"
#include "core/values/journalentry.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"
#include "core/values/series.h"

#include <QHash>
#include <QMutex>
#include <QSet>

#include <vector>

namespace gorizont {

/// What other threads left for the archive. A store that hangs must not eat the memory: beyond the limits the oldest are
/// dropped, and it is known of which sensor and time they were. Thread-safe.
class ArchiveInbox
{
public:
    static constexpr std::size_t mostReadings = 200'000;
    static constexpr qsizetype mostBlocks = 20'000; ///< of all sensors together
    static constexpr qsizetype mostEntries = 10'000;
    static constexpr qsizetype mostBackfills = 1000;

    struct LineChange
    {
        LineStatus status;
        UtcTime time;
    };
    struct Contents
    {
        std::vector<Reading> readings; ///< in the order of arrival, like the others
        QList<LineChange> lines; ///< only changes of the state
        QList<SampleBlock> blocks;
        QList<JournalEntry> entries;
        QList<Backfill> backfills;
        QHash<int, TimeSpan> dropped; ///< N → of what readings there was no room for
        QHash<int, TimeSpan> droppedBlocks; ///< likewise of samples
        qsizetype blocksDropped = 0;
        qsizetype entriesDropped = 0;
        qsizetype backfillsDropped = 0;
    };

    void put(const Readings &batch);
    void put(const LineStatus &status, UtcTime now);
    void put(const SampleBlock &block);
    void put(const JournalEntry &entry);
    void put(const Backfill &backfill);

    /// Everything; the inbox is empty then.
    Contents take();
    std::size_t waitingReadings() const;

private:
    void dropOldest();
    void dropOldestBlock();

    mutable QMutex m_mutex;
    Contents m_contents;
    QHash<int, LineState> m_states; ///< port → the last one
    QSet<int> m_torn; ///< N whose last block was dropped, and none came since
};

} // namespace gorizont
