#include "ui/plots/lineextremes.h"

#include <algorithm>
#include <limits>

namespace gorizont {

namespace {

constexpr std::ptrdiff_t sizeOfBlock = 256;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// What QCPRange itself does not allow.
QCPRange none()
{
    QCPRange range;
    range.lower = infinite;
    range.upper = -infinite;
    return range;
}

void take(QCPRange &range, double lower, double upper)
{
    range.lower = lower < range.lower ? lower : range.lower; // false for what is not a number
    range.upper = upper > range.upper ? upper : range.upper;
}

} // namespace

std::optional<QCPRange> LineExtremes::within(const QCPGraphDataContainer &line, const QCPRange &keys)
{
    const auto begin = line.constBegin();
    const auto whole = static_cast<std::size_t>(line.size() / sizeOfBlock);
    while (m_blocks.size() < whole) {
        const auto first = begin + static_cast<std::ptrdiff_t>(m_blocks.size()) * sizeOfBlock;
        QCPRange range = none();
        std::for_each(first, first + sizeOfBlock, [&range](const QCPGraphData &point) {
            take(range, point.value, point.value);
        });
        m_blocks.push_back(range);
    }
    const std::ptrdiff_t end = line.findEnd(keys.upper, false) - begin;
    QCPRange range = none();
    for (std::ptrdiff_t at = line.findBegin(keys.lower, false) - begin; at < end;) {
        if (at % sizeOfBlock == 0 && at + sizeOfBlock <= end) {
            const QCPRange &block = m_blocks[static_cast<std::size_t>(at / sizeOfBlock)];
            take(range, block.lower, block.upper);
            at += sizeOfBlock;
        } else {
            take(range, (begin + at)->value, (begin + at)->value);
            ++at;
        }
    }
    return range.lower <= range.upper ? std::optional(range) : std::nullopt;
}

} // namespace gorizont
