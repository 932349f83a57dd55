#pragma once

#include "core/values/timing.h"

#include <optional>

namespace gorizont {

/// Notices that somebody set the clock of the computer: it compares the wall with the steady clock. Pure.
class ClockWatch
{
public:
    /// Smaller differences are the ordinary work of a time service.
    static constexpr std::chrono::seconds tolerance{1};

    /// By how much the clock was set since the last call, positive: forward; empty: it was not.
    std::optional<std::chrono::microseconds> step(UtcTime wall, SteadyTime steady);

private:
    std::optional<std::chrono::microseconds> m_offset; ///< wall − steady at the last call
};

} // namespace gorizont
