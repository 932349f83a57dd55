#include "core/engine/pollingcycle.h"

#include <algorithm>

namespace gorizont {

PollingCycle::PollingCycle(int sensorCount, const Timing &timing)
    : m_sensorCount(sensorCount)
    , m_period(timing.run)
    , m_idle(timing.idle)
    , m_pauseTick(timing.pauseTick)
{
}

void PollingCycle::restart(SteadyTime now)
{
    m_position = 0;
    m_cycleStart = now;
    m_nextTurnAt = now;
}

bool PollingCycle::advance(SteadyTime now, std::chrono::milliseconds pause)
{
    m_hasAsked = true;
    m_nextTurnAt = now + pause;
    return step(now);
}

bool PollingCycle::skip(SteadyTime now)
{
    return step(now);
}

/// A cycle in which nobody was asked ends with a pause tick, so that a line of parked sensors does not spin.
bool PollingCycle::step(SteadyTime now)
{
    if (++m_position < m_sensorCount) {
        return false;
    }
    const auto rest = m_hasAsked ? m_idle : std::max(m_idle, m_pauseTick);
    m_position = 0;
    m_hasAsked = false;
    m_nextTurnAt = std::max<SteadyTime>({m_cycleStart + m_period, m_nextTurnAt, now + rest});
    m_cycleStart = m_nextTurnAt;
    return true;
}

} // namespace gorizont
