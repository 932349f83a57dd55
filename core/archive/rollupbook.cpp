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
            last.buckets = decodeRollup(*stored, kind).value_or(Buckets());
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

} // namespace gorizont
