#pragma once

#include "core/archive/archivedatabase.h"
#include "core/archive/archivestore.h"
#include "core/archive/rollup.h"
#include "core/archive/tailbatch.h"

#include <QTimeZone>

#include <functional>
#include <utility>

namespace gorizont {

/// What the archive answers, from a connection that only reads and stops no writer. Lives on one thread.
class ArchiveQuery
{
public:
    /// True: the answer is wanted no more; what comes back then means nothing.
    using IsCancelled = std::function<bool()>;

    explicit ArchiveQuery(const ArchiveConfig &config)
        : m_database(config, ArchiveDatabase::Access::Read)
    {
    }

    /// Empty answers too where there is no archive yet. What cannot be read is left out, see takeFailure().
    QList<Series> series(const SeriesQuery &query, const IsCancelled &isCancelled = {});
    QList<Gap> gaps(const QList<int> &numbers, UtcTime from, UtcTime to);
    /// Days by the clock of \a zone, from \a first to \a last.
    QList<DayCompleteness> completeness(const QList<int> &numbers, QDate first, QDate last, const QTimeZone &zone);
    QList<JournalEntry> events(UtcTime from, UtcTime to, int most);
    QList<SampleBlock> blocks(int number, UtcTime from, UtcTime to);
    QList<DeviceRecord> records(int number, UtcTime from, UtcTime to);

    /// True: an answer since the last call lacks what could not be read.
    bool takeFailure() { return std::exchange(m_hasFailed, false); }

    /// The file is another one: it is opened again for the next question.
    void reopen() { m_database.close(); }
    ArchiveDatabase &database() { return m_database; }

private:
    bool prepare();
    bool begin();
    bool next(QSqlQuery *rows);
    QVariant single(const QString &sql, const QVariantList &values = {});
    void loadTail(const QSet<int> &numbers);
    Series seriesOf(const SeriesKey &key, const SeriesQuery &query, const IsCancelled &isCancelled);
    Buckets storedRollups(
        ChunkKind kind, const SeriesKey &key, UtcTime from, UtcTime to, const IsCancelled &isCancelled);
    Buckets tailBuckets(const SeriesKey &key, std::chrono::microseconds step) const;
    Buckets fullRate(
        const SeriesKey &key, UtcTime from, UtcTime to, std::chrono::microseconds step, const IsCancelled &isCancelled);
    QList<TimeSpan> gapSpans(int number, UtcTime from, UtcTime to);

    ArchiveDatabase m_database;
    QHash<int, KnownSensor> m_known;
    TailBatch::Contents m_tail; ///< what is in no chunk, of the sensors asked for
    bool m_hasFailed = false;
};

/// The steps in which a stretch can be answered.
struct SeriesStep
{
    ChunkKind kind = ChunkKind::FullRate;
    std::chrono::microseconds step{0}; ///< 0: every value by itself
    bool operator==(const SeriesStep &) const = default;
};

/// The coarsest one that makes at least \a width buckets of \a span; \a width 0: full rate.
SeriesStep stepFor(std::chrono::microseconds span, int width);

} // namespace gorizont
