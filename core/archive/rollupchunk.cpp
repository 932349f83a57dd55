#include "core/archive/rollupchunk.h"

#include "core/archive/integercolumn.h"
#include "core/archive/valuecolumn.h"

#include <cmath>
#include <limits>

namespace gorizont {

namespace {

constexpr qint64 partsOfMean = 16;

struct Extremes
{
    std::vector<double> minima;
    std::vector<double> maxima;
    std::vector<double> means;
};

Extremes extremesOf(const Buckets &buckets)
{
    Extremes extremes;
    for (const SeriesBucket &bucket : buckets) {
        if (bucket.valid > 0) {
            extremes.minima.push_back(bucket.minimum);
            extremes.maxima.push_back(bucket.maximum);
            extremes.means.push_back(bucket.mean);
        }
    }
    return extremes;
}

void appendOnGrid(ArchiveBytes &bytes, const Extremes &extremes, const ValueGrid &grid)
{
    std::vector<qint64> minima;
    std::vector<qint64> heights;
    std::vector<qint64> means;
    for (std::size_t i = 0; i < extremes.minima.size(); ++i) {
        const qint64 minimum = *grid.whole(extremes.minima[i]);
        const double mean = (extremes.means[i] - extremes.minima[i]) * grid.parts * partsOfMean;
        minima.push_back(minimum);
        heights.push_back(*grid.whole(extremes.maxima[i]) - minimum);
        means.push_back(std::llround(mean));
    }
    appendIntegers(bytes, minima);
    appendIntegers(bytes, heights);
    appendIntegers(bytes, means);
}

Extremes takeOnGrid(ArchiveCursor &cursor, const ValueGrid &grid, quint64 count)
{
    const std::vector<qint64> minima = takeIntegers(cursor, count);
    const std::vector<qint64> heights = takeIntegers(cursor, count);
    const std::vector<qint64> means = takeIntegers(cursor, count);
    Extremes extremes;
    for (std::size_t i = 0; i < minima.size() && cursor.isGood(); ++i) {
        const auto sum = static_cast<qint64>(static_cast<quint64>(minima[i]) + static_cast<quint64>(heights[i]));
        const double minimum = grid.value(minima[i]);
        extremes.minima.push_back(minimum);
        extremes.maxima.push_back(grid.value(sum));
        extremes.means.push_back(minimum + static_cast<double>(means[i]) / (double{partsOfMean} * grid.parts));
    }
    return extremes;
}

std::vector<qint64> takeCounts(ArchiveCursor &cursor, quint64 count)
{
    std::vector<qint64> counts = takeIntegers(cursor, count);
    for (const qint64 one : counts) {
        if (one < 0 || one > std::numeric_limits<quint32>::max()) {
            cursor.fail();
            return {};
        }
    }
    return counts;
}

template <typename Number> std::vector<qint64> each(const Buckets &buckets, const Number &number)
{
    std::vector<qint64> all;
    all.reserve(static_cast<std::size_t>(buckets.size()));
    for (const SeriesBucket &bucket : buckets) {
        all.push_back(number(bucket));
    }
    return all;
}

/// Empty where an index is farther away than times are kept.
Buckets frame(const std::vector<qint64> &indices, ChunkKind kind)
{
    const qint64 farthest = (qint64{1} << 60) / stepOf(kind).count();
    Buckets buckets;
    buckets.reserve(static_cast<qsizetype>(indices.size()));
    for (const qint64 index : indices) {
        if (index < -farthest || index > farthest) {
            return {};
        }
        SeriesBucket bucket;
        bucket.from = UtcTime(index * stepOf(kind));
        buckets.append(bucket);
    }
    return buckets;
}

bool fill(
    Buckets &buckets, const std::vector<qint64> &counts, const std::vector<qint64> &valid, const Extremes &extremes)
{
    std::size_t next = 0;
    for (qsizetype i = 0; i < buckets.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        SeriesBucket &bucket = buckets[i];
        bucket.count = static_cast<quint32>(counts[at]);
        bucket.valid = static_cast<quint32>(valid[at]);
        if (bucket.valid > 0) {
            bucket.minimum = extremes.minima[next];
            bucket.maximum = extremes.maxima[next];
            bucket.mean = extremes.means[next++];
        }
        if (i > 0 && bucket.from <= buckets.at(i - 1).from) {
            return false;
        }
    }
    return true;
}

} // namespace

QByteArray encodeRollup(ChunkKind kind, const Buckets &buckets, double offset)
{
    ArchiveBytes bytes;
    bytes.byte(chunkVersion);
    bytes.byte(static_cast<quint8>(kind));
    bytes.number(static_cast<quint64>(buckets.size()));
    appendIntegers(bytes, each(buckets, [kind](const SeriesBucket &bucket) {
                       return bucket.from.time_since_epoch() / stepOf(kind);
                   }));
    appendIntegers(bytes, each(buckets, [](const SeriesBucket &bucket) { return qint64{bucket.count}; }));
    appendIntegers(bytes, each(buckets, [](const SeriesBucket &bucket) { return qint64{bucket.valid}; }));
    const Extremes extremes = extremesOf(buckets);
    std::vector<double> ends = extremes.minima;
    ends.insert(ends.end(), extremes.maxima.begin(), extremes.maxima.end());
    const auto grid = gridOf(ends, offset);
    appendGrid(bytes, grid);
    if (grid) {
        appendOnGrid(bytes, extremes, *grid);
    } else {
        appendValues(bytes, extremes.minima, offset);
        appendValues(bytes, extremes.maxima, offset);
        appendValues(bytes, extremes.means, 0);
    }
    return bytes.sealed();
}

std::optional<Buckets> decodeRollup(QByteArrayView bytes, ChunkKind kind)
{
    ArchiveCursor cursor = ArchiveCursor::ofSealed(bytes);
    const quint64 count = takeChunkHead(cursor, kind);
    Buckets buckets = frame(takeIntegers(cursor, count), kind);
    const std::vector<qint64> counts = takeCounts(cursor, count);
    const std::vector<qint64> valid = takeCounts(cursor, count);
    const auto values = static_cast<quint64>(std::count_if(valid.begin(), valid.end(), [](qint64 n) { return n > 0; }));
    const auto grid = takeGrid(cursor);
    Extremes extremes;
    if (grid) {
        extremes = takeOnGrid(cursor, *grid, values);
    } else {
        extremes.minima = takeValues(cursor, values);
        extremes.maxima = takeValues(cursor, values);
        extremes.means = takeValues(cursor, values);
    }
    if (!cursor.isGood() || !cursor.isAtEnd() || static_cast<quint64>(buckets.size()) != count) {
        return {};
    }
    return fill(buckets, counts, valid, extremes) ? std::optional(std::move(buckets)) : std::nullopt;
}

} // namespace gorizont
