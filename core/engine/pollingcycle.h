#pragma once

#include "core/values/timing.h"

namespace gorizont {

/// When the turns of a port take place. Pure: time is given. A cycle passes every sensor once and starts every TmRun;
/// one that comes late starts at once and moves the grid, so that nothing is ever queued.
class PollingCycle
{
public:
    PollingCycle(int sensorCount, const Timing &timing);

    void restart(SteadyTime now);

    int position() const { return m_position; } ///< index of the next sensor
    SteadyTime nextTurnAt() const { return m_nextTurnAt; }
    /// The cycle is over and the next one has not begun: the line is free until nextTurnAt().
    bool isBetweenCycles() const { return m_position == 0; }

    /// The sensor at position() had its turn; \a pause follows it (SRError, SCRCError). True: that ended a cycle.
    bool advance(SteadyTime now, std::chrono::milliseconds pause);
    /// The sensor at position() is parked and was passed over. True: that ended a cycle.
    bool skip(SteadyTime now);

private:
    bool step(SteadyTime now);

    int m_sensorCount;
    std::chrono::milliseconds m_period;
    std::chrono::milliseconds m_idle;
    std::chrono::milliseconds m_pauseTick;
    bool m_hasAsked = false; ///< somebody had a turn in this cycle
    int m_position = 0;
    SteadyTime m_cycleStart{};
    SteadyTime m_nextTurnAt{};
};

} // namespace gorizont
