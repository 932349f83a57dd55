#include "core/archive/rollupbook.h"

#include "core/archive/rollupchunk.h"

namespace gorizont {

ValueColumn columnOf(const SampleChunk &chunk, Quantity axis)
{
    ValueColumn column;
    column.quantity = axis;
    const std::vector<qint64> &raw = axis == Quantity::SampleX ? chunk.x : chunk.y;
    column.values.reserve(raw.size());
    for (const qint64 sample : raw) {
        column.values.push_back(static_cast<double>(sample) * chunk.scale);
    }
    column.isValid.assign(raw.size(), true);
    return column;
}

bool RollupBook::add(int number, const ReadingChunk &chunk, const ValueOffsets &offsets)
{
    for (const ValueColumn &column : chunk.columns) {
        if (!addAll({number, column.quantity}, chunk.times, column, offsets.of(column.quantity))) {
            return false;
        }
    }
    return true;
}

bool RollupBook::add(int number, const SampleChunk &chunk)
{
    const std::vector<UtcTime> times = chunk.times();
    return addAll({number, Quantity::SampleX}, times, columnOf(chunk, Quantity::SampleX), 0)
        && addAll({number, Quantity::SampleY}, times, columnOf(chunk, Quantity::SampleY), 0);
}

bool RollupBook::addAll(
    const SeriesKey &key, const std::vector<UtcTime> &times, const ValueColumn &column, double offset)
{
    Buckets buckets = bucketsOf(times, column, stepOf(ChunkKind::Minutes));
    for (const ChunkKind kind : rollupKinds) {
        buckets = coarsened(buckets, stepOf(kind));
        if (!add(kind, key, buckets, offset)) {
            return false;
        }
    }
    return true;
}

bool RollupBook::add(ChunkKind kind, const SeriesKey &key, const Buckets &buckets, double offset)
{
    qsizetype from = 0;
    while (from < buckets.size()) {
        const UtcTime start = floored(buckets.at(from).from, stretchOf(kind));
        qsizetype to = from;
        while (to < buckets.size() && buckets.at(to).from < start + stretchOf(kind)) {
            ++to;
        }
        if (!addToStretch(kind, key, start, buckets.mid(from, to - from), offset)) {
            return false;
        }
        from = to;
    }
    return true;
}

bool RollupBook::addToStretch(
    ChunkKind kind, const SeriesKey &key, UtcTime start, const Buckets &buckets, double offset)
{
    Stretch &last = m_last[{kind, key}];
    if (last.buckets.isEmpty() || last.start != start) {
        last = {start, {}};
        if (const auto stored = m_store.rollup(kind, key, start)) {
            const auto known = decodeRollup(*stored, kind);
            if (!known) {
                return replaceStretch(kind, key, start, buckets, offset);
            }
            last.buckets = *known;
        } else if (m_store.database().fault() != ArchiveFault::None) {
            return false;
        }
    }
    if (!last.buckets.isEmpty() && last.buckets.last().from < buckets.first().from) {
        last.buckets += buckets;
    } else {
        last.buckets = merged(last.buckets, buckets);
    }
    return m_store.putRollup(kind, key, start, encodeRollup(kind, last.buckets, offset));
}

/// What is stored cannot be read. What it is made of may hold \a buckets already: the fuller one of a time counts.
bool RollupBook::replaceStretch(
    ChunkKind kind, const SeriesKey &key, UtcTime start, const Buckets &buckets, double offset)
{
    const auto again = rebuilt(kind, key, start);
    if (!again) {
        return false;
    }
    ++m_damaged;
    std::map<UtcTime, SeriesBucket> fullest;
    for (const SeriesBucket &bucket : *again + buckets) {
        SeriesBucket &kept = fullest[bucket.from];
        kept = bucket.count > kept.count ? bucket : kept;
    }
    Stretch &last = m_last[{kind, key}];
    last = {start, {}};
    for (const auto &[from, bucket] : fullest) {
        last.buckets.append(bucket);
    }
    return m_store.putRollup(kind, key, start, encodeRollup(kind, last.buckets, offset));
}

/// From the rollups of the finer kind, minutes from chunks: as far as they are there.
std::optional<Buckets> RollupBook::rebuilt(ChunkKind kind, const SeriesKey &key, UtcTime start)
{
    const TimeSpan span{start, start + stretchOf(kind)};
    const auto finer = kind == ChunkKind::Days ? ChunkKind::Hours : ChunkKind::Minutes;
    std::optional<Buckets> parts = kind == ChunkKind::Minutes ? fromChunks(key, span) : fromRollups(finer, key, span);
    if (!parts) {
        return {};
    }
    Buckets buckets;
    for (const SeriesBucket &bucket : coarsened(*parts, stepOf(kind))) {
        if (bucket.from >= span.from && bucket.from < span.to) {
            buckets.append(bucket);
        }
    }
    return buckets;
}

std::optional<Buckets> RollupBook::fromRollups(ChunkKind kind, const SeriesKey &key, const TimeSpan &span)
{
    const auto rows = m_store.rollups(kind, key, span);
    if (!rows) {
        return {};
    }
    Buckets buckets;
    for (const QByteArray &row : *rows) {
        buckets += decodeRollup(row, kind).value_or(Buckets());
    }
    return buckets;
}

std::optional<Buckets> RollupBook::fromChunks(const SeriesKey &key, const TimeSpan &span)
{
    const bool isSample = key.quantity == Quantity::SampleX || key.quantity == Quantity::SampleY;
    const auto rows = m_store.chunks(isSample ? ChunkKind::Samples : ChunkKind::FullRate, key.number, span);
    if (!rows) {
        return {};
    }
    Buckets buckets;
    for (const QByteArray &row : *rows) {
        if (const auto chunk = isSample ? decodeSampleChunk(row) : std::nullopt) {
            const ValueColumn column = columnOf(*chunk, key.quantity);
            buckets = merged(buckets, bucketsOf(chunk->times(), column, stepOf(ChunkKind::Minutes)));
        } else if (const auto readings = isSample ? std::nullopt : decodeReadingChunk(row, key.quantity);
                   readings && !readings->columns.empty()) {
            buckets =
                merged(buckets, bucketsOf(readings->times, readings->columns.front(), stepOf(ChunkKind::Minutes)));
        }
    }
    return buckets;
}

} // namespace gorizont
