#pragma once

#include "core/archive/rollup.h"

namespace gorizont {

/// The buckets of one curve in one stretch. Where minima and maxima are on a grid, means are kept to a sixteenth of its
/// step, otherwise all three bit by bit. Pure.
///
///     version 1 · kind 3, 4 or 5 · count · indices (integers: time ÷ step) · counts · valid counts (integers)
///     form as in a column of values, and then only of buckets that have a valid value:
///     grid    minimum · maximum − minimum · mean × 16 − minimum × 16 (integers, in steps of the grid)
///     bits    minimum · maximum · mean (columns of values)
///     CRC-32
/// \a offset: as for appendValues().
QByteArray encodeRollup(ChunkKind kind, const Buckets &buckets, double offset);

/// Empty: \a bytes are damaged, of another kind, or of a version that is not known.
std::optional<Buckets> decodeRollup(QByteArrayView bytes, ChunkKind kind);

} // namespace gorizont
