#include "core/station/gammasensor.h"

namespace gorizont::station {

GammaSensor::GammaSensor(const GammaConfig &config)
    : m_config(config)
{
}

GammaSensor::Second GammaSensor::step(qint64 pulses, std::chrono::minutes minute)
{
    m_isCheckDue = m_isCheckDue || (m_minute && *m_minute != minute && minute == m_config.checkAt);
    m_minute = minute;
    m_pulses += pulses;
    m_inGate += std::chrono::seconds(1);
    Second second;
    if (m_inGate >= m_config.gate) {
        closeGate(second);
    }
    if (m_closedPulses) {
        second.frequency = static_cast<double>(*m_closedPulses) / static_cast<double>(m_config.gate.count());
    }
    second.isBlinkerOn = m_isBlinkerOn;
    return second;
}

void GammaSensor::closeGate(Second &second)
{
    if (m_isBlinkerOn) {
        second.check = Check{m_closedPulses.value_or(0), m_pulses};
        m_isBlinkerOn = false;
    } else {
        m_closedPulses = m_pulses;
        m_isBlinkerOn = m_isCheckDue; // a check takes the next whole gate
        m_isCheckDue = false;
    }
    m_pulses = 0;
    m_inGate = std::chrono::seconds(0);
}

} // namespace gorizont::station
