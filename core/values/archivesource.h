#pragma once

#include "core/values/gap.h"
#include "core/values/journalentry.h"
#include "core/values/sampleblock.h"
#include "core/values/series.h"

namespace gorizont {

/// What an archive keeps of the past, as questions. Every future is finished in another thread, or cancelled when the source has
/// gone; whoever asks may forget it. An empty function: this is not kept.
struct ArchiveSource
{
    using Sensors = QList<int>; ///< N

    /// The gaps that overlap from ≤ t < to, in ascending time for each sensor.
    std::function<QFuture<QList<Gap>>(const Sensors &numbers, UtcTime from, UtcTime to)> gaps;
    /// Of each sensor and each local day from \a first to \a last; days of which nothing is known are left out.
    std::function<QFuture<QList<DayCompleteness>>(const Sensors &numbers, QDate first, QDate last)> completeness;
    /// In ascending time, from ≤ t < to, and of them the last \a most.
    std::function<QFuture<QList<JournalEntry>>(UtcTime from, UtcTime to, int most)> events;
    SeriesSource series;
    /// Of one sensor, in ascending time: the blocks that overlap from ≤ t < to.
    std::function<QFuture<QList<SampleBlock>>(int number, UtcTime from, UtcTime to)> blocks;
};

} // namespace gorizont
