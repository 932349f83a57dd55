#pragma once

#include "core/values/timing.h"

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

} // namespace gorizont
