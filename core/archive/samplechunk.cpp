#include "core/archive/samplechunk.h"

#include "core/archive/chunkkind.h"
#include "core/archive/timecolumn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gorizont {

namespace {

std::chrono::microseconds samplesLast(double rate, qint64 count)
{
    return std::chrono::microseconds(std::llround(static_cast<double>(count) * 1e6 / rate));
}

std::vector<qint64> takeSamples(ArchiveCursor &cursor, quint64 count)
{
    std::vector<qint64> samples = takeIntegers(cursor, count);
    using Limits = std::numeric_limits<qint16>;
    if (std::any_of(samples.begin(), samples.end(), [](qint64 s) { return s < Limits::min() || s > Limits::max(); })) {
        cursor.fail();
    }
    return samples;
}

/// 0: the sizes are not those of a chunk.
quint64 sumOf(const std::vector<qint64> &sizes)
{
    quint64 sum = 0;
    for (const qint64 size : sizes) {
        if (size < 1 || static_cast<quint64>(size) > mostInColumn) {
            return 0;
        }
        sum += static_cast<quint64>(size);
    }
    return sum;
}

} // namespace

bool SampleChunk::append(const SampleBlock &block)
{
    const qsizetype count = std::min(block.x.size(), block.y.size());
    if (starts.empty()) {
        followsPrevious = block.followsPrevious;
        rate = block.rate;
        scale = block.scale;
    } else if (
        !block.followsPrevious || block.rate != rate || block.scale != scale || block.start <= starts.back()
        || x.size() + static_cast<std::size_t>(count) > mostInColumn) {
        return false;
    }
    starts.push_back(block.start);
    sizes.push_back(count);
    x.insert(x.end(), block.x.begin(), block.x.begin() + count);
    y.insert(y.end(), block.y.begin(), block.y.begin() + count);
    return true;
}

std::vector<UtcTime> SampleChunk::times() const
{
    std::vector<UtcTime> all;
    all.reserve(x.size());
    for (std::size_t block = 0; block < starts.size(); ++block) {
        for (qint64 i = 0; i < sizes[block]; ++i) {
            all.push_back(starts[block] + samplesLast(rate, i));
        }
    }
    return all;
}

UtcTime SampleChunk::end() const
{
    return starts.empty() ? UtcTime() : starts.back() + samplesLast(rate, sizes.back());
}

QByteArray encodeChunk(const SampleChunk &chunk)
{
    ArchiveBytes bytes;
    bytes.byte(chunkVersion);
    bytes.byte(static_cast<quint8>(ChunkKind::Samples));
    bytes.number(chunk.starts.size());
    bytes.byte(chunk.followsPrevious ? 1 : 0);
    bytes.real(chunk.rate);
    bytes.real(chunk.scale);
    appendTimes(bytes, chunk.starts);
    appendIntegers(bytes, chunk.sizes);
    appendIntegers(bytes, chunk.x);
    appendIntegers(bytes, chunk.y);
    return bytes.sealed();
}

std::optional<SampleChunk> decodeSampleChunk(QByteArrayView bytes)
{
    ArchiveCursor cursor = ArchiveCursor::ofSealed(bytes);
    const quint64 count = takeChunkHead(cursor, ChunkKind::Samples);
    SampleChunk chunk;
    chunk.followsPrevious = cursor.byte() != 0;
    chunk.rate = cursor.real();
    chunk.scale = cursor.real();
    chunk.starts = takeTimes(cursor, count);
    chunk.sizes = takeIntegers(cursor, count);
    const quint64 samples = sumOf(chunk.sizes);
    if (!cursor.isGood() || !(chunk.rate >= 1e-3) || !(chunk.rate <= 1e6) || !std::isfinite(chunk.scale)
        || (samples == 0 && count > 0)) {
        return {};
    }
    chunk.x = takeSamples(cursor, samples);
    chunk.y = takeSamples(cursor, samples);
    return cursor.isGood() && cursor.isAtEnd() ? std::optional(std::move(chunk)) : std::nullopt;
}

} // namespace gorizont
