#include "core/devices/lvims/lvimssimulator.h"

namespace gorizont::lvims {

namespace {

constexpr qsizetype headSize = 7; ///< transaction, protocol, length, unit

int numberAt(const QByteArray &bytes, qsizetype at)
{
    return quint8(bytes[at]) * 256 + quint8(bytes[at + 1]);
}

int unitOf(const SensorConfig &sensor)
{
    bool isNumber = false;
    const int unit = sensor.options.value(QStringLiteral("unit")).toInt(&isNumber);
    return isNumber ? unit : 1;
}

} // namespace

Simulator::Simulator(const SensorConfig &sensor, quint64 seed)
    : SimulatedDevice(sensor.number, sensor.address)
    , m_unit(unitOf(sensor))
    , m_module(seed + static_cast<quint64>(sensor.number))
{
}

/// A length that makes no sense leaves no way to the next request: all that was heard is forgotten.
QByteArray Simulator::receive(QByteArrayView bytes, Time now)
{
    QByteArray answers;
    m_heard.append(bytes.data(), bytes.size());
    while (m_heard.size() >= headSize + 1) {
        const int length = numberAt(m_heard, 4);
        if (length < 2 || length > 254) {
            m_heard.clear();
            break;
        }
        if (m_heard.size() < 6 + length) {
            break;
        }
        const QByteArray request = m_heard.left(6 + length);
        m_heard.remove(0, request.size());
        if (quint8(request[6]) != m_unit) {
            continue;
        }
        const QByteArray pdu = m_module.answer(QByteArrayView(request).sliced(headSize), now);
        answers += request.left(4);
        answers += static_cast<char>((pdu.size() + 1) / 256);
        answers += static_cast<char>((pdu.size() + 1) % 256);
        answers += request.mid(6, 1) + pdu;
    }
    return answers;
}

void Simulator::reboot(Time now)
{
    m_heard.clear();
    m_module.restart(now);
}

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed)
{
    return std::make_unique<Simulator>(sensor, seed);
}

} // namespace gorizont::lvims
