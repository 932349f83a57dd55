#include "core/devices/and3/and3packet.h"

#include "core/devices/and3/and3protocol.h"
#include "core/protocol/bytes.h"

namespace gorizont::and3 {

namespace {

constexpr qsizetype axisSize = packetSamples * static_cast<qsizetype>(sizeof(qint16));

QList<qint16> samplesAt(QByteArrayView bytes, qsizetype offset)
{
    QList<qint16> samples(packetSamples);
    qFromLittleEndian<qint16>(bytes.sliced(offset, axisSize).data(), packetSamples, samples.data());
    return samples;
}

/// \a bytes are packetSize bytes.
Packet parsePacket(QByteArrayView bytes)
{
    Packet packet;
    packet.x = samplesAt(bytes, 0);
    packet.y = samplesAt(bytes, axisSize);
    const quint32 start = *readLittle<quint32>(bytes, 128);
    const quint32 stop = *readLittle<quint32>(bytes, 132);
    const quint32 high = *readLittle<quint32>(bytes, 136);
    const quint32 startHigh = start > stop ? high - 1 : high; // the high part is that of the stop
    packet.start = (static_cast<quint64>(startHigh) << 32) | start;
    packet.stop = (static_cast<quint64>(high) << 32) | stop;
    packet.errors = *readLittle<quint16>(bytes, 140);
    packet.drz = *readLittle<quint16>(bytes, 142);
    packet.ax = *readLittle<quint16>(bytes, 144);
    packet.ay = *readLittle<quint16>(bytes, 146);
    return packet;
}

} // namespace

std::optional<QList<Packet>> parsePackets(QByteArrayView answer)
{
    const QByteArrayView data = dataOf(answer);
    if (data.isEmpty() || data.size() % packetSize != 0) {
        return std::nullopt;
    }
    QList<Packet> packets;
    packets.reserve(data.size() / packetSize);
    for (qsizetype at = 0; at < data.size(); at += packetSize) {
        packets.append(parsePacket(data.sliced(at, packetSize)));
    }
    return packets;
}

} // namespace gorizont::and3
