#pragma once

#include "core/values/result.h"
#include "core/values/timing.h"

namespace gorizont {

/// Counts what a sensor failed at and decides when it is asked again. Pure: time is given. A sensor that reached one of
/// its limits is parked: probed at growing intervals, so that its neighbours on the line keep their period.
class SensorHealth
{
public:
    static constexpr std::chrono::seconds shortestProbe{2};
    static constexpr std::chrono::seconds longestProbe{30};

    SensorHealth(int readErrorLimit, int crcErrorLimit);

    void succeeded();
    /// Checksum counts as a CRC error, every other fault of a sensor as a read error. The counters "in a row" are
    /// independent: only a good answer resets them.
    void failed(Fault fault, SteadyTime now);
    /// The line was opened anew: nothing is held against the sensor.
    void restart();

    /// A parked sensor is asked at the next opportunity; nothing is forgiven.
    void probeSoon() { m_probeAt = {}; }

    bool isParked() const;
    /// Whether the sensor takes part in a cycle that passes it at \a now.
    bool isDue(SteadyTime now) const { return !isParked() || now >= m_probeAt; }

    int readErrorsInRow() const { return m_readErrorsInRow; }
    int crcErrorsInRow() const { return m_crcErrorsInRow; }

private:
    int m_readErrorLimit;
    int m_crcErrorLimit;
    int m_readErrorsInRow = 0;
    int m_crcErrorsInRow = 0;
    std::chrono::seconds m_probePause{shortestProbe};
    SteadyTime m_probeAt{};
};

} // namespace gorizont
