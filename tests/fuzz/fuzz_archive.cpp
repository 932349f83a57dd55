#include "core/archive/readingchunk.h"
#include "core/archive/rollupchunk.h"
#include "core/archive/samplechunk.h"
#include "core/archive/tailbatch.h"
#include "tests/fuzz/scancheck.h"

#include "core/archive/archivebytes.h"

#include <cstdint>

using namespace gorizont;

namespace {

/// What is taken for good is written again and read as the same.
void checkAll(QByteArrayView bytes)
{
    if (const auto chunk = decodeReadingChunk(bytes)) {
        const auto again = decodeReadingChunk(encodeChunk(*chunk));
        fuzz::require(again && again->times == chunk->times, "the same readings");
        decodeReadingChunk(bytes, Quantity::TiltY);
    }
    if (const auto chunk = decodeSampleChunk(bytes)) {
        fuzz::require(decodeSampleChunk(encodeChunk(*chunk)) == chunk, "the same samples");
        fuzz::require(chunk->times().size() == chunk->x.size(), "a time a sample");
    }
    for (const ChunkKind kind : rollupKinds) {
        if (const auto buckets = decodeRollup(bytes, kind)) {
            coarsened(*buckets, std::chrono::hours(24));
        }
    }
    if (const auto tail = TailBatch::decode(bytes)) {
        TailBatch batch;
        for (const KeptReading &reading : tail->readings) {
            batch.add(reading);
        }
        const auto again = TailBatch::decode(batch.take());
        fuzz::require(again && again->readings.size() == tail->readings.size(), "the same tail");
    }
}

} // namespace

/// Any bytes as they are, and with a good check sum, so that what is behind it is reached.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    checkAll(bytes);
    ArchiveBytes content;
    content.raw(bytes.size() > 4 ? bytes.chopped(4) : bytes);
    checkAll(content.sealed());
    return 0;
}
