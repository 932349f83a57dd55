#include "core/archive/archivequery.h"

#include "core/archive/gapmath.h"
#include "core/archive/openchunks.h"
#include "core/archive/rollupbook.h"
#include "core/archive/rollupchunk.h"

#include <QFileInfo>

#include <algorithm>

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

bool isSample(Quantity quantity)
{
    return quantity == Quantity::SampleX || quantity == Quantity::SampleY;
}

/// Values one by one where \a step is 0.
void appendBuckets(
    Buckets &all, const std::vector<UtcTime> &times, const ValueColumn &column, std::chrono::microseconds step)
{
    if (step.count() > 0) {
        all = merged(all, bucketsOf(times, column, step));
        return;
    }
    all.reserve(all.size() + static_cast<qsizetype>(times.size()));
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (column.isValid[i]) {
            const double value = column.values[i];
            all.append({times[i], value, value, value, 1, 1});
        }
    }
}

void keepBetween(Buckets &buckets, UtcTime from, UtcTime to)
{
    buckets.erase(
        std::remove_if(
            buckets.begin(), buckets.end(),
            [from, to](const SeriesBucket &bucket) { return bucket.from < from || bucket.from >= to; }),
        buckets.end());
}

/// What the tail has of one curve, as a column.
ValueColumn tailColumn(const TailBatch::Contents &tail, const SeriesKey &key, std::vector<UtcTime> &times)
{
    ValueColumn column;
    column.quantity = key.quantity;
    for (const KeptReading &reading : tail.readings) {
        if (reading.number != key.number) {
            continue;
        }
        for (const KeptValue &kept : reading.values) {
            if (kept.quantity == key.quantity) {
                times.push_back(reading.time);
                column.values.push_back(kept.value.value_or(0));
                column.isValid.push_back(kept.value.has_value());
            }
        }
    }
    for (const SampleBlock &block : tail.blocks) {
        SampleChunk chunk;
        if (block.number == key.number && isSample(key.quantity) && chunk.append(block)) {
            const std::vector<UtcTime> own = chunk.times();
            const ValueColumn part = columnOf(chunk, key.quantity);
            times.insert(times.end(), own.begin(), own.end());
            column.values.insert(column.values.end(), part.values.begin(), part.values.end());
            column.isValid.insert(column.isValid.end(), part.isValid.begin(), part.isValid.end());
        }
    }
    return column;
}

void appendBlocks(QList<SampleBlock> &blocks, int number, const SampleChunk &chunk)
{
    auto at = static_cast<std::ptrdiff_t>(0);
    for (std::size_t i = 0; i < chunk.starts.size(); ++i) {
        SampleBlock block{number, chunk.starts[i], chunk.rate, chunk.scale, i > 0 || chunk.followsPrevious, {}, {}};
        for (qint64 sample = 0; sample < chunk.sizes[i]; ++sample, ++at) {
            block.x.append(static_cast<qint16>(chunk.x[static_cast<std::size_t>(at)]));
            block.y.append(static_cast<qint16>(chunk.y[static_cast<std::size_t>(at)]));
        }
        blocks.append(block);
    }
}

UtcTime startOf(QDate day, const QTimeZone &zone)
{
    return UtcTime(std::chrono::milliseconds(day.startOfDay(zone).toMSecsSinceEpoch()));
}

} // namespace

bool ArchiveQuery::prepare()
{
    const bool isFile = m_database.isSqlite();
    // A server that was started again in between has to be connected to again.
    if (m_database.isOpen() && (isFile || m_database.execute(u"SELECT 1"_s))) {
        return true;
    }
    if (isFile && !QFileInfo::exists(m_database.config().file)) {
        return false;
    }
    const bool isOpen = m_database.open();
    m_hasFailed = m_hasFailed || (!isOpen && m_database.fault() != ArchiveFault::Empty);
    return isOpen;
}

bool ArchiveQuery::begin()
{
    const bool isReady = prepare();
    const bool hasBegun = isReady && m_database.begin();
    m_hasFailed = m_hasFailed || isReady != hasBegun;
    return hasBegun;
}

/// An error is not the end of the rows.
bool ArchiveQuery::next(QSqlQuery *rows)
{
    if (rows && rows->next()) {
        return true;
    }
    m_hasFailed = !m_database.isWhole(rows) || m_hasFailed;
    return false;
}

QVariant ArchiveQuery::single(const QString &sql, const QVariantList &values)
{
    const QVariant value = m_database.single(sql, values);
    m_hasFailed = m_hasFailed || (!value.isValid() && m_database.fault() != ArchiveFault::None);
    return value;
}

void ArchiveQuery::loadTail(const QSet<int> &numbers)
{
    m_known.clear();
    m_tail = {};
    QSqlQuery *sensors =
        m_database.run(u"SELECT number, known_from, known_until, readings_done, samples_done FROM sensor"_s);
    while (next(sensors)) {
        m_known.insert(
            sensors->value(0).toInt(),
            {readTime(sensors->value(1)), readTime(sensors->value(2)), sensors->value(3).toLongLong(),
             sensors->value(4).toLongLong()});
    }
    QSqlQuery *rows = m_database.run(u"SELECT id, data FROM tail ORDER BY id"_s);
    while (next(rows)) {
        const qint64 id = rows->value(0).toLongLong();
        const auto contents = TailBatch::decode(rows->value(1).toByteArray(), numbers);
        if (!contents) {
            continue;
        }
        for (const KeptReading &reading : contents->readings) {
            if (id > m_known.value(reading.number).readingsDone) {
                m_tail.readings.append(reading);
            }
        }
        for (const SampleBlock &block : contents->blocks) {
            if (id > m_known.value(block.number).samplesDone) {
                m_tail.blocks.append(block);
            }
        }
    }
}

QList<Series> ArchiveQuery::series(const SeriesQuery &query, const IsCancelled &isCancelled)
{
    QList<Series> all;
    const bool isReady = begin();
    if (isReady) {
        QSet<int> numbers;
        for (const SeriesKey &key : query.keys) {
            numbers.insert(key.number);
        }
        loadTail(numbers);
    }
    for (const SeriesKey &key : query.keys) {
        all.append(isReady ? seriesOf(key, query, isCancelled) : Series{key, {}, {}, {}});
    }
    if (isReady) {
        m_database.rollback();
    }
    return all;
}

Series ArchiveQuery::seriesOf(const SeriesKey &key, const SeriesQuery &query, const IsCancelled &isCancelled)
{
    const SeriesStep step = stepFor(query.to - query.from, query.width);
    const UtcTime from = step.step.count() > 0 ? floored(query.from, step.step) : query.from;
    Series series{key, step.step, {}, gapSpans(key.number, query.from, query.to)};
    if (step.kind == ChunkKind::FullRate) {
        series.buckets = fullRate(key, from, query.to, step.step, isCancelled);
    } else {
        const Buckets stored = storedRollups(step.kind, key, from, query.to, isCancelled);
        series.buckets = merged(coarsened(stored, step.step), tailBuckets(key, step.step));
    }
    keepBetween(series.buckets, from, query.to);
    return series;
}

Buckets ArchiveQuery::storedRollups(
    ChunkKind kind, const SeriesKey &key, UtcTime from, UtcTime to, const IsCancelled &isCancelled)
{
    Buckets all;
    QSqlQuery *rows = m_database.run(
        u"SELECT data FROM rollup WHERE kind = ? AND number = ? AND quantity = ? AND start >= ? AND start < ? "
        "ORDER BY start"_s,
        {static_cast<int>(kind), key.number, static_cast<int>(key.quantity), storedTime(floored(from, stretchOf(kind))),
         storedTime(to)});
    while (next(rows) && !(isCancelled && isCancelled())) {
        if (const auto buckets = decodeRollup(rows->value(0).toByteArray(), kind)) {
            all += *buckets;
        }
    }
    return all;
}

Buckets ArchiveQuery::tailBuckets(const SeriesKey &key, std::chrono::microseconds step) const
{
    std::vector<UtcTime> times;
    const ValueColumn column = tailColumn(m_tail, key, times);
    return bucketsOf(times, column, step);
}

Buckets ArchiveQuery::fullRate(
    const SeriesKey &key, UtcTime from, UtcTime to, std::chrono::microseconds step, const IsCancelled &isCancelled)
{
    Buckets all;
    const ChunkKind kind = isSample(key.quantity) ? ChunkKind::Samples : ChunkKind::FullRate;
    QSqlQuery *rows = m_database.run(
        u"SELECT data FROM chunk WHERE kind = ? AND number = ? AND start >= ? AND start < ? AND finish > ? "
        "ORDER BY start"_s,
        {static_cast<int>(kind), key.number, storedTime(from - 2 * OpenChunks::longest), storedTime(to),
         storedTime(from)});
    while (next(rows) && !(isCancelled && isCancelled())) {
        const QByteArray data = rows->value(0).toByteArray();
        if (kind == ChunkKind::Samples) {
            if (const auto chunk = decodeSampleChunk(data)) {
                appendBuckets(all, chunk->times(), columnOf(*chunk, key.quantity), step);
            }
        } else if (const auto chunk = decodeReadingChunk(data, key.quantity); chunk && !chunk->columns.empty()) {
            appendBuckets(all, chunk->times, chunk->columns.front(), step);
        }
    }
    std::vector<UtcTime> times;
    const ValueColumn column = tailColumn(m_tail, key, times);
    appendBuckets(all, times, column, step);
    const auto isEarlier = [](const SeriesBucket &a, const SeriesBucket &b) { return a.from < b.from; };
    if (!std::is_sorted(all.cbegin(), all.cend(), isEarlier)) {
        std::stable_sort(all.begin(), all.end(), isEarlier);
    }
    return all;
}

QList<TimeSpan> ArchiveQuery::gapSpans(int number, UtcTime from, UtcTime to)
{
    QList<TimeSpan> spans;
    QSqlQuery *rows = m_database.run(
        u"SELECT start, finish FROM gap WHERE number = ? AND start < ? AND (finish IS NULL OR finish > ?) "
        "AND source = '' ORDER BY start"_s,
        {number, storedTime(to), storedTime(from)});
    while (next(rows)) {
        spans.append({readTime(rows->value(0)), rows->isNull(1) ? to : readTime(rows->value(1))});
    }
    return spans;
}

QList<Gap> ArchiveQuery::gaps(const QList<int> &numbers, UtcTime from, UtcTime to)
{
    QList<Gap> gaps;
    for (qsizetype i = 0; i < numbers.size() && prepare(); ++i) {
        QSqlQuery *rows = m_database.run(
            u"SELECT start, finish, reason, source FROM gap WHERE number = ? AND start < ? AND (finish IS NULL OR "
            "finish > ?) ORDER BY start"_s,
            {numbers.at(i), storedTime(to), storedTime(from)});
        while (next(rows)) {
            Gap gap{numbers.at(i), readTime(rows->value(0)), {}, static_cast<GapReason>(rows->value(2).toInt()), {}};
            if (!rows->isNull(1)) {
                gap.to = readTime(rows->value(1));
            }
            gap.filledFrom = rows->value(3).toString();
            gaps.append(gap);
        }
    }
    return gaps;
}

QList<DayCompleteness> ArchiveQuery::completeness(
    const QList<int> &numbers, QDate first, QDate last, const QTimeZone &zone)
{
    QList<DayCompleteness> days;
    if (!prepare()) {
        return days;
    }
    const UtcTime from = startOf(first, zone);
    const UtcTime to = startOf(last.addDays(1), zone);
    const UtcTime alive = readTime(single(u"SELECT value FROM meta WHERE name = 'alive'"_s));
    for (const int number : numbers) {
        const QVariant known = single(u"SELECT known_from FROM sensor WHERE number = ?"_s, {number});
        if (known.isValid()) {
            const TimeSpan span{std::max(from, readTime(known)), std::min(to, alive)};
            days += gorizont::completeness(number, gaps({number}, from, to), span, zone);
        }
    }
    return days;
}

QList<JournalEntry> ArchiveQuery::events(UtcTime from, UtcTime to, int most)
{
    QList<JournalEntry> events;
    if (!prepare()) {
        return events;
    }
    QSqlQuery *rows = m_database.run(
        u"SELECT kind, time, text, port, number FROM event WHERE time >= ? AND time < ? ORDER BY time DESC, id DESC "
        "LIMIT ?"_s,
        {storedTime(from), storedTime(to), most});
    while (next(rows)) {
        events.prepend(
            {static_cast<JournalKind>(rows->value(0).toInt()), readTime(rows->value(1)), rows->value(2).toString(),
             rows->value(3).toInt(), rows->value(4).toInt()});
    }
    return events;
}

QList<SampleBlock> ArchiveQuery::blocks(int number, UtcTime from, UtcTime to)
{
    QList<SampleBlock> blocks;
    if (!begin()) {
        return blocks;
    }
    loadTail({number});
    QSqlQuery *rows = m_database.run(
        u"SELECT data FROM chunk WHERE kind = ? AND number = ? AND start >= ? AND start < ? AND finish > ? ORDER BY "
        "start"_s,
        {static_cast<int>(ChunkKind::Samples), number, storedTime(from - 2 * OpenChunks::longest), storedTime(to),
         storedTime(from)});
    while (next(rows)) {
        if (const auto chunk = decodeSampleChunk(rows->value(0).toByteArray())) {
            appendBlocks(blocks, number, *chunk);
        }
    }
    m_database.rollback();
    blocks += m_tail.blocks;
    blocks.erase(
        std::remove_if(
            blocks.begin(), blocks.end(),
            [from, to](const SampleBlock &block) {
                const auto length = std::chrono::duration<double>(static_cast<double>(block.x.size()) / block.rate);
                return block.start >= to
                    || block.start + std::chrono::duration_cast<std::chrono::microseconds>(length) <= from;
            }),
        blocks.end());
    return blocks;
}

QList<DeviceRecord> ArchiveQuery::records(int number, UtcTime from, UtcTime to)
{
    QList<DeviceRecord> records;
    if (!prepare()) {
        return records;
    }
    QSqlQuery *rows = m_database.run(
        u"SELECT start, name, data FROM record WHERE number = ? AND start >= ? AND start < ? ORDER BY start"_s,
        {number, storedTime(from), storedTime(to)});
    while (next(rows)) {
        records.append({number, readTime(rows->value(0)), rows->value(1).toString(), rows->value(2).toByteArray()});
    }
    return records;
}

} // namespace gorizont
