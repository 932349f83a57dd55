#include "core/archive/valuecolumn.h"

#include "core/archive/integercolumn.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace gorizont {

namespace {

enum Form : quint8 { Bits, Grid, GridWithOffset };

/// Parts of a unit that devices measure in; coarse ones first.
constexpr std::array<quint32, 17> usualParts{1,   2,   4,    5,    8,      10,     16,      20,       100,
                                             128, 256, 1000, 4096, 10'000, 65'536, 100'000, 1'000'000};

constexpr double mostWhole = 9007199254740992.0; ///< 2⁵³

/// Ascending numbers for ascending values.
qint64 orderedBits(double value)
{
    const auto bits = std::bit_cast<qint64>(value);
    return bits < 0 ? bits ^ std::numeric_limits<qint64>::max() : bits;
}
double fromOrderedBits(qint64 bits)
{
    return std::bit_cast<double>(bits < 0 ? bits ^ std::numeric_limits<qint64>::max() : bits);
}

bool hasAll(const ValueGrid &grid, std::span<const double> values)
{
    for (const double value : values) {
        if (!grid.whole(value)) {
            return false;
        }
    }
    return true;
}

} // namespace

std::optional<qint64> ValueGrid::whole(double wanted) const
{
    const double scaled = (wanted + offset) * parts;
    if (!(std::abs(scaled) < mostWhole)) {
        return {};
    }
    const auto n = static_cast<qint64>(scaled + (scaled < 0 ? -0.5 : 0.5));
    return value(n) == wanted ? std::optional(n) : std::nullopt;
}

std::optional<ValueGrid> gridOf(std::span<const double> values, double offset)
{
    for (const quint32 parts : usualParts) {
        if (const ValueGrid grid{parts, 0}; hasAll(grid, values)) {
            return grid;
        }
    }
    if (offset != 0 && std::isfinite(offset)) {
        for (const quint32 parts : usualParts) {
            if (const ValueGrid grid{parts, offset}; hasAll(grid, values)) {
                return grid;
            }
        }
    }
    return {};
}

void appendGrid(ArchiveBytes &bytes, const std::optional<ValueGrid> &grid)
{
    if (!grid) {
        bytes.byte(Bits);
        return;
    }
    bytes.byte(grid->offset == 0 ? Grid : GridWithOffset);
    bytes.number(grid->parts);
    if (grid->offset != 0) {
        bytes.real(grid->offset);
    }
}

std::optional<ValueGrid> takeGrid(ArchiveCursor &cursor)
{
    const quint8 form = cursor.byte();
    if (form == Bits) {
        return {};
    }
    const quint64 parts = cursor.number();
    const double offset = form == GridWithOffset ? cursor.real() : 0;
    if (form > GridWithOffset || parts == 0 || parts > std::numeric_limits<quint32>::max()) {
        cursor.fail();
        return {};
    }
    return ValueGrid{static_cast<quint32>(parts), offset};
}

void appendValues(ArchiveBytes &bytes, std::span<const double> values, double offset)
{
    const auto grid = gridOf(values, offset);
    appendGrid(bytes, grid);
    std::vector<qint64> numbers;
    numbers.reserve(values.size());
    for (const double value : values) {
        numbers.push_back(grid ? *grid->whole(value) : orderedBits(value));
    }
    appendIntegers(bytes, numbers);
}

std::vector<double> takeValues(ArchiveCursor &cursor, quint64 count)
{
    const auto grid = takeGrid(cursor);
    const std::vector<qint64> numbers = takeIntegers(cursor, count);
    std::vector<double> values;
    values.reserve(numbers.size());
    for (const qint64 number : numbers) {
        values.push_back(grid ? grid->value(number) : fromOrderedBits(number));
    }
    return values;
}

} // namespace gorizont
