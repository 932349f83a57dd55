#pragma once

#include "core/simulation/simulatedline.h"

namespace gorizont::test {

/// A simulated line on a clock of its own: bytes and silence last as long as on a wire and cost no real time.
class SimulatedTimeLine : public SimulatedLine
{
public:
    SimulatedTimeLine(const LineConfig &config, const SimulatedBus::Options &options)
        : SimulatedLine(config, options, SteadyTime(start), std::chrono::milliseconds(100))
    {
        static_cast<void>(open());
    }

    std::chrono::microseconds elapsed() const
    {
        return std::chrono::duration_cast<std::chrono::microseconds>(m_now - SteadyTime(start));
    }
    int requests() const { return m_requests; } ///< how many were sent
    void wait(std::chrono::milliseconds time) { m_now += time; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override
    {
        ++m_requests;
        return SimulatedLine::writeAll(bytes, timeout);
    }
    SteadyTime now() const override { return m_now; }
    void sleepUntil(SteadyTime time) override { m_now = std::max(m_now, time); }

private:
    static constexpr std::chrono::hours start{1};

    SteadyTime m_now{start};
    int m_requests = 0;
};

} // namespace gorizont::test
