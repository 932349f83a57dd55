#pragma once

#include "core/archive/keptreading.h"

#include <QByteArray>

#include <vector>

namespace gorizont {

/// One quantity in a chunk.
struct ValueColumn
{
    Quantity quantity = Quantity::TiltX;
    std::vector<double> values; ///< as many as times; 0 where not valid
    std::vector<bool> isValid; ///< as many as times
    bool operator==(const ValueColumn &) const = default;
};

/// Consecutive readings of one sensor at full rate, all of what it measured. Pure.
///
///     version 1 · kind 1 · count of readings · times (integers, µs UTC)
///     count of columns, and of each: quantity (byte), piece {valid, values}
///     valid   0: all; 1: integers, 1 where a value is; only those have values
///     CRC-32
struct ReadingChunk
{
    std::vector<UtcTime> times;
    std::vector<ValueColumn> columns; ///< ascending quantities
    bool operator==(const ReadingChunk &) const = default;

    std::size_t size() const { return times.size(); }
    /// A quantity that is new gets a column that is invalid before.
    void append(const KeptReading &reading);
    /// null: nothing was kept of \a quantity.
    const ValueColumn *column(Quantity quantity) const;
};

/// What the configuration of a sensor subtracts, for the codec to find the device's own numbers.
struct ValueOffsets
{
    double x = 0; ///< arc-seconds
    double y = 0; ///< arc-seconds
    double temperature = 0; ///< °C
    double of(Quantity quantity) const;
};

QByteArray encodeChunk(const ReadingChunk &chunk, const ValueOffsets &offsets = {});

/// Empty: \a bytes are damaged, or of a version that is not known. With \a only, other columns are left out.
std::optional<ReadingChunk> decodeReadingChunk(QByteArrayView bytes, std::optional<Quantity> only = {});

} // namespace gorizont
