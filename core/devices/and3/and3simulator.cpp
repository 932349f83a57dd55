#include "core/devices/and3/and3simulator.h"

#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"

#include <algorithm>
#include <cmath>

namespace gorizont::and3 {

namespace {

using namespace std::chrono_literals;

constexpr qsizetype requestBytes = 6;
constexpr auto resetDelay = 1s;
constexpr std::size_t addressByte = 4;
constexpr std::size_t innerAddressByte = 5;
constexpr quint8 key1 = 66; ///< arguments of what must not happen by accident
constexpr quint8 key2 = 99;

template <typename T> void append(QByteArray &bytes, double value)
{
    const double low = std::numeric_limits<T>::min();
    const double high = std::numeric_limits<T>::max();
    appendLittle<T>(bytes, static_cast<T>(std::lround(std::clamp(value, low, high))));
}

QByteArray fourBytes(quint32 value)
{
    QByteArray bytes;
    appendLittle<quint32>(bytes, value);
    return bytes;
}

} // namespace

And3Simulator::And3Simulator(const SensorConfig &sensor, quint64 seed)
    : SimulatedDevice(sensor.number, sensor.address)
    , m_motion(seed, sensor.number)
    , m_hasThermostat(sensor.hasThermostat)
{
    m_nonVolatile[addressByte] = static_cast<quint8>(sensor.address);
    m_nonVolatile[innerAddressByte] = 1;
    m_current = m_nonVolatile;
    m_temporary = m_nonVolatile;
}

/// Requests are found by their check sum wherever they begin, so noise and halves of requests do no harm.
QByteArray And3Simulator::receive(QByteArrayView bytes, Time now)
{
    if (m_resetAt && now >= *m_resetAt) {
        reboot(*m_resetAt);
    }
    if (m_resetAt) {
        return {};
    }
    QByteArray answer;
    for (const char c : bytes) {
        m_heard.append(c);
        m_heard = m_heard.right(requestBytes);
        const auto sum = readLittle<quint16>(m_heard, requestBytes - 2);
        if (!sum || *sum != crc16CcittFalse(QByteArrayView(m_heard).chopped(2))) {
            continue;
        }
        const quint8 to = byteAt(m_heard, 0);
        if (to == 0 || to == address()) {
            const QByteArray reply = obey(byteAt(m_heard, 1), byteAt(m_heard, 2), byteAt(m_heard, 3), now);
            answer += to == 0 ? QByteArray() : reply;
        }
        m_heard.clear();
    }
    return answer;
}

void And3Simulator::reboot(Time now)
{
    m_resetAt.reset();
    m_heard.clear();
    m_bootedAt = now;
    m_isRebootAcknowledged = false;
    m_current = m_nonVolatile;
    m_temporary = m_nonVolatile;
    setAddress(m_current[addressByte]);
    m_ring.restart(now);
}

void And3Simulator::overrunRing(Time now)
{
    m_ring.overrun(now);
}

/// The answer; empty: the device does not know what is meant and stays silent.
QByteArray And3Simulator::obey(quint8 op, quint8 b1, quint8 b2, Time now)
{
    const bool hasKey = b1 == key1 && b2 == key2;
    switch (op) {
    case 36: return information(b1, now);
    case 50: return changeMode(b1, b2, now);
    case 99:
        if (!hasKey) {
            return {};
        }
        m_resetAt = now + resetDelay;
        return reply(op);
    case 201: return complexRead(now);
    case 203: return packets(b1, std::max<int>(b2, 1), now);
    case 205: return reply(op);
    case 206: m_ring.clear(now); return reply(op);
    case 220:
        if (!hasKey) {
            return {};
        }
        m_nonVolatile = m_temporary;
        return reply(op, QByteArray(2, '\0'));
    case 221: return configuration(b1);
    case 224: return setByte(b1, b2);
    case 225: m_temporary = m_current; return reply(op);
    default: return {};
    }
}

QByteArray And3Simulator::reply(quint8 op, const QByteArray &data) const
{
    QByteArray bytes;
    appendByte(bytes, address());
    appendByte(bytes, op);
    bytes += data;
    appendLittle<quint16>(bytes, crc16CcittFalse(bytes));
    return bytes;
}

QByteArray And3Simulator::information(quint8 kind, Time now) const
{
    switch (kind) {
    case 0: return reply(36, fourBytes(static_cast<quint32>((now - m_bootedAt).count() * 40))); // clock, 25 ns
    case 2: return reply(36, fourBytes(m_hasThermostat ? static_cast<quint32>(10 * m_motion.heaterPower(now)) : 0));
    case 3: return reply(36, fourBytes(m_hasThermostat ? 1000 : 0));
    case 4: return reply(36, QByteArray::fromHex("0C030200")); // 2.3, build 12
    case 5: return reply(36, fourBytes(m_current[innerAddressByte]));
    case 7: return reply(36, fourBytes(250));
    default: return {};
    }
}

QByteArray And3Simulator::changeMode(quint8 bit, quint8 value, Time now)
{
    if (bit == 6 && value == 1) {
        m_ring.stop(now);
    } else if (bit == 6 && value == 0) {
        m_ring.run(now);
    } else if (bit == 101 && value == 1) {
        m_isRebootAcknowledged = true;
    } else {
        return {};
    }
    return reply(50);
}

QByteArray And3Simulator::complexRead(Time now) const
{
    QByteArray data;
    append<qint16>(data, 8 * m_motion.tiltX(now));
    append<qint16>(data, 8 * m_motion.tiltY(now));
    append<qint16>(data, 250 * m_motion.temperature(now));
    append<quint16>(data, m_hasThermostat ? 8 * m_motion.fanFrequency(now) : 0);
    append<quint16>(data, m_hasThermostat ? 10 * m_motion.heaterPower(now) : 0);
    appendLittle<quint16>(data, rawStatus());
    appendLittle<quint32>(data, m_ring.samples(now));
    appendLittle<quint16>(data, modeWord());
    return reply(201, data);
}

QByteArray And3Simulator::packets(int firstCell, int count, Time now) const
{
    if (firstCell + count > 128) { // what a sensor does across the end of the ring is not specified
        return {};
    }
    QByteArray data;
    for (int i = 0; i < count; ++i) {
        data += m_ring.packet(firstCell + i, now, m_motion);
    }
    return reply(203, data);
}

QByteArray And3Simulator::configuration(quint8 kind) const
{
    if (kind > 2) {
        return {};
    }
    const Configuration &bytes = kind == 0 ? m_current : kind == 1 ? m_temporary : m_nonVolatile;
    return reply(221, QByteArray(reinterpret_cast<const char *>(bytes.data()), bytes.size()));
}

QByteArray And3Simulator::setByte(quint8 index, quint8 value)
{
    if (index >= m_temporary.size()) {
        return {};
    }
    m_temporary[index] = value;
    return reply(224);
}

/// `0010 0100 0000 1111` is a healthy sensor without a fan: it complains of that.
quint16 And3Simulator::rawStatus() const
{
    const quint16 healthy = m_hasThermostat ? 0x200F : 0x240F;
    return m_isRebootAcknowledged ? healthy : healthy & ~1;
}

quint16 And3Simulator::modeWord() const
{
    return m_ring.isRunning() ? 0xCC00 : 0xCC40;
}

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed)
{
    return std::make_unique<And3Simulator>(sensor, seed);
}

} // namespace gorizont::and3
