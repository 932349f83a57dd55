#pragma once

#include "core/archive/archivebytes.h"

#include <span>
#include <vector>

namespace gorizont {

/// A column of integers, as small as a device's noise allows: what a predictor leaves of each is written in Rice code,
/// 64 at a time. All arithmetic wraps at 64 bits, so that every column comes back as it was. Pure.
///
///     predictor  number: 0 the parameter; 1 the value before; 2 the two before, continued; 3 a straight line
///     parameter  0: a signed number near the middle; 1, 2: the first value, signed;
///                3: the first value, then the slope in 1/65536 of a unit a step, both signed
///     bits       lowest first. A block: 6 bits k, 1 bit "flagged", then up to 64 residuals, zigzag.
///                k = 63: all of them are 0. Flagged: one bit says whether a residual is other than 0, and then its
///                zigzag less 1 follows. Rice: n >> k as ones and a zero, then the k low bits of n; where there would
///                be 24 ones or more, 24 of them and all 64 bits of n.
void appendIntegers(ArchiveBytes &bytes, std::span<const qint64> values);

/// \a count: how many there are, as the caller knows; at most mostInColumn. Empty where \a cursor is not good then.
std::vector<qint64> takeIntegers(ArchiveCursor &cursor, quint64 count);

constexpr quint64 mostInColumn = 1 << 17;

} // namespace gorizont
