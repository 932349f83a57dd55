#pragma once

#include "core/values/sampleblock.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace gorizont {

/// Blocks of raw samples of one accelerometer, without a gap between them and all of one rate and scale. Pure.
///
///     version 1 · kind 2 · count of blocks · byte: 1 the first block follows the chunk before · rate (double) · scale (double)
///     starts (integers, µs UTC) · sizes (integers) · x (integers) · y (integers) · CRC-32
struct SampleChunk
{
    bool followsPrevious = false; ///< no sample is missing between the chunk before and this one
    double rate = 10; ///< samples a second
    double scale = 1; ///< mm/s² of one raw unit, with its sign
    std::vector<UtcTime> starts; ///< of the blocks
    std::vector<qint64> sizes; ///< samples in each of them; 1…
    std::vector<qint64> x; ///< raw units
    std::vector<qint64> y; ///< as many as x

    bool operator==(const SampleChunk &) const = default;

    /// False: \a block does not continue this chunk and was not appended.
    bool append(const SampleBlock &block);
    /// When sample \a i of the whole chunk was taken; one time a sample.
    std::vector<UtcTime> times() const;
    /// Just after the last sample.
    UtcTime end() const;
};

QByteArray encodeChunk(const SampleChunk &chunk);

/// Empty: \a bytes are damaged, or of a version that is not known.
std::optional<SampleChunk> decodeSampleChunk(QByteArrayView bytes);

} // namespace gorizont
