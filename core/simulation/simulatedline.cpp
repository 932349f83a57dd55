#include "core/simulation/simulatedline.h"

#include <algorithm>

namespace gorizont {

SimulatedLine::SimulatedLine(
    const LineConfig &config, const SimulatedBus::Options &options, SteadyTime started,
    std::chrono::milliseconds pauseTick)
    : Line(pauseTick)
    , m_bus(config, options)
    , m_started(started)
{
}

Result<void> SimulatedLine::open()
{
    m_isOpen = true;
    return {};
}

void SimulatedLine::close()
{
    m_isOpen = false;
    m_arriving.clear();
}

/// Returns when the last byte is on the wire, as a port does that waits for its transmitter.
Result<void> SimulatedLine::writeAll(QByteArrayView bytes, std::chrono::milliseconds)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    const SteadyTime started = now();
    m_arriving += m_bus.receive(bytes, std::chrono::duration_cast<SimulatedBus::Time>(started - m_started));
    std::stable_sort(m_arriving.begin(), m_arriving.end(), [](const auto &a, const auto &b) { return a.at < b.at; });
    sleepUntil(started + m_bus.wireTime(bytes.size()));
    return {};
}

Result<QByteArray> SimulatedLine::readSome(std::chrono::microseconds timeout)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    const SteadyTime deadline = now() + timeout;
    if (m_arriving.isEmpty() || m_started + m_arriving.first().at > deadline) {
        if (timeout.count() > 0) {
            sleepUntil(deadline);
        }
        return QByteArray();
    }
    sleepUntil(m_started + m_arriving.first().at);
    return m_arriving.takeFirst().bytes;
}

} // namespace gorizont
