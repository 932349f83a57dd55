#include "core/devices/ind3/ind3simulatorports.h"

namespace gorizont::ind3 {

QByteArray Port210::hear(char heard, SimulatedSensor &sensor, BuildingMotion::Time now)
{
    m_buffer = m_buffer.right(5) + heard;
    if (m_buffer.size() < 6 || !m_buffer.startsWith("\x7E\x9A") || !m_buffer.endsWith('\x7E')) {
        return {};
    }
    const auto packet = static_cast<unsigned char>(m_buffer.at(2));
    const auto address = static_cast<unsigned char>(m_buffer.at(3));
    const auto sum = static_cast<unsigned char>(m_buffer.at(4));
    if ((packet + address + sum) % 256 != 0) {
        return {};
    }
    m_buffer.clear();
    if (address != sensor.address) {
        return {};
    }
    if (packet == 3) {
        return QByteArray(1, '\x35');
    }
    if (packet != 1) {
        return {};
    }
    const QByteArray data = angleBytes(sensor.angle(0, now), sensor.angle(1, now));
    unsigned total = 0;
    for (const char c : data) {
        total += static_cast<unsigned char>(c);
    }
    return data + static_cast<char>(256 - total % 256);
}

} // namespace gorizont::ind3
