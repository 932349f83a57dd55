#pragma once

#include "ui/plots/plotting.h"

#include <optional>
#include <vector>

namespace gorizont {

/// The extremes of a line that only grows at its end, found without a look at every value of it. GUI thread.
class LineExtremes
{
public:
    /// The line is another one.
    void forget() { m_blocks.clear(); }
    /// Of \a line within \a keys; empty: nothing valid is there.
    std::optional<QCPRange> within(const QCPGraphDataContainer &line, const QCPRange &keys);

private:
    std::vector<QCPRange> m_blocks; ///< of whole blocks of values; upper < lower: nothing valid
};

} // namespace gorizont
