#include "core/simulation/simulatedline.h"

#include <algorithm>

#ifdef Q_OS_LINUX
#include <sys/prctl.h>
#endif

namespace gorizont {

namespace {

/// By default the system lets every sleep last 50 µs longer, half a byte at 115200.
void sleepExactly()
{
#ifdef Q_OS_LINUX
    prctl(PR_SET_TIMERSLACK, 1UL);
#endif
}

} // namespace

SimulatedLine::SimulatedLine(
    const LineConfig &config, const SimulatedBus::Options &options, SteadyTime started,
    std::chrono::milliseconds pauseTick)
    : Line(pauseTick)
    , m_bus(config, options)
    , m_configured(*port())
    , m_started(started)
{
}

Result<void> SimulatedLine::open()
{
    sleepExactly();
    m_bus.setPort(m_configured);
    m_isOpen = true;
    return {};
}

void SimulatedLine::close()
{
    m_isOpen = false;
    m_arriving.clear();
}

Result<void> SimulatedLine::setPort(const PortSettings &port)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    m_arriving.clear();
    m_bus.setPort(port);
    return {};
}

/// Returns at once, as a port does whose driver takes the bytes into its buffer.
Result<void> SimulatedLine::writeAll(QByteArrayView bytes, std::chrono::milliseconds)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    m_arriving += m_bus.receive(bytes, std::chrono::duration_cast<SimulatedBus::Time>(now() - m_started));
    std::stable_sort(m_arriving.begin(), m_arriving.end(), [](const auto &a, const auto &b) { return a.at < b.at; });
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
