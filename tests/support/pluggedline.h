#pragma once

#include "core/simulation/simulatedline.h"

#include <atomic>

namespace gorizont::test {

/// A simulated line that can be pulled out and plugged in from the thread of the test.
class PluggedLine : public SimulatedLine
{
public:
    PluggedLine(const LineConfig &config, const SimulatedBus::Options &options, std::atomic_bool &isPlugged)
        : SimulatedLine(config, options, std::chrono::steady_clock::now(), std::chrono::milliseconds(100))
        , m_isPlugged(isPlugged)
    {
    }

    Result<void> open() override
    {
        setLastError(2, QStringLiteral("no such port"));
        return m_isPlugged ? SimulatedLine::open() : Result<void>(Fault::Closed);
    }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override
    {
        if (!m_isPlugged) {
            close();
        }
        return SimulatedLine::writeAll(bytes, timeout);
    }

    Result<QByteArray> readSome(std::chrono::microseconds timeout) override
    {
        if (!m_isPlugged) {
            close();
        }
        return SimulatedLine::readSome(timeout);
    }

private:
    std::atomic_bool &m_isPlugged;
};

} // namespace gorizont::test
