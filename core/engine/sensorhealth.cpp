#include "core/engine/sensorhealth.h"

#include <algorithm>

namespace gorizont {

SensorHealth::SensorHealth(int readErrorLimit, int crcErrorLimit)
    : m_readErrorLimit(readErrorLimit)
    , m_crcErrorLimit(crcErrorLimit)
{
}

void SensorHealth::succeeded()
{
    restart();
}

void SensorHealth::failed(Fault fault, SteadyTime now)
{
    const bool wasParked = isParked();
    ++(fault == Fault::Checksum ? m_crcErrorsInRow : m_readErrorsInRow);
    if (isParked()) {
        m_probePause = wasParked ? std::min(2 * m_probePause, longestProbe) : shortestProbe;
        m_probeAt = now + m_probePause;
    }
}

void SensorHealth::restart()
{
    m_readErrorsInRow = 0;
    m_crcErrorsInRow = 0;
}

bool SensorHealth::isParked() const
{
    return m_readErrorsInRow >= m_readErrorLimit || m_crcErrorsInRow >= m_crcErrorLimit;
}

} // namespace gorizont
