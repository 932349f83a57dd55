#pragma once

#include "core/values/timing.h"

#include <optional>

namespace gorizont {

/// Ticks at start + n × period, so that the period is exact on average; a tick that came too late is dropped, never
/// made up for. Pure.
class Cadence
{
public:
    Cadence(SteadyTime start, std::chrono::milliseconds period)
        : m_start(start)
        , m_period(period)
    {
    }

    /// The first tick after \a now.
    SteadyTime next(SteadyTime now) const { return m_start + ((now - m_start) / m_period + 1) * m_period; }

private:
    SteadyTime m_start;
    std::chrono::milliseconds m_period;
};

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
