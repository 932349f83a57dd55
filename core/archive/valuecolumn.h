#pragma once

#include "core/archive/archivebytes.h"

#include <optional>
#include <span>
#include <vector>

namespace gorizont {

/// How a device's values became doubles: value = n / parts − offset, of whole n.
struct ValueGrid
{
    quint32 parts = 1; ///< of a unit; 1…
    double offset = 0; ///< in the unit
    bool operator==(const ValueGrid &) const = default;

    double value(qint64 n) const { return static_cast<double>(n) / parts - offset; }
    /// Empty: \a value is none of the grid's, to the last bit.
    std::optional<qint64> whole(double value) const;
};

/// The coarsest grid that has all of \a values exactly; empty: they are on none that devices use. \a offset: what the
/// configuration subtracts from what the device says; tried beside 0.
std::optional<ValueGrid> gridOf(std::span<const double> values, double offset);

/// A column of doubles. What is on a grid is kept as whole numbers, the rest bit by bit, so that all come back equal to
/// what they were (of −0 only that it is 0). Pure.
///
///     form    byte: 0 bits of doubles; 1 grid; 2 grid with an offset
///     parts   1, 2: number;   offset   2: double
///     then the integers: n; or the bits of the doubles, those of negative ones inverted below the sign
void appendValues(ArchiveBytes &bytes, std::span<const double> values, double offset);

/// \a count: how many there are. Empty where \a cursor is not good then.
std::vector<double> takeValues(ArchiveCursor &cursor, quint64 count);

void appendGrid(ArchiveBytes &bytes, const std::optional<ValueGrid> &grid);
/// Empty: bits of doubles, or \a cursor is not good then.
std::optional<ValueGrid> takeGrid(ArchiveCursor &cursor);

} // namespace gorizont
