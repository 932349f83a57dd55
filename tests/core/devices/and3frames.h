#pragma once

#include <QByteArray>

#include <initializer_list>

/// Frames of the АН-Д3 for its tests, written from spec/and3.md without the codec: the check sum goes bit by bit.
namespace gorizont::test {

inline QByteArray sealed(QByteArray frame)
{
    unsigned crc = 0xFFFF;
    for (const char c : frame) {
        crc ^= static_cast<unsigned>(static_cast<unsigned char>(c)) << 8;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc << 1) ^ ((crc & 0x8000) ? 0x1021 : 0);
        }
    }
    frame.append(static_cast<char>(crc & 0xFF));
    frame.append(static_cast<char>((crc >> 8) & 0xFF));
    return frame;
}

/// Bytes, check sum added: sealed({1, 201, 0, 0}).
inline QByteArray sealed(std::initializer_list<int> bytes)
{
    QByteArray frame;
    for (const int byte : bytes) {
        frame.append(static_cast<char>(byte));
    }
    return sealed(frame);
}

inline void addWord(QByteArray &bytes, quint32 value, int size)
{
    for (int i = 0; i < size; ++i) {
        bytes.append(static_cast<char>((value >> (8 * i)) & 0xFF));
    }
}

/// An answer 201 at rest; only what the tests turn.
inline QByteArray complexReadAnswer(quint32 samples, quint16 status = 0x240F, quint16 mode = 0xCC00, int address = 1)
{
    QByteArray frame;
    addWord(frame, static_cast<quint32>(address), 1);
    addWord(frame, 201, 1);
    addWord(frame, 80, 2); // 10″
    addWord(frame, 0xFFB0, 2); // −10″
    addWord(frame, 5000, 2); // 20 °C
    addWord(frame, 336, 2); // 42 s⁻¹
    addWord(frame, 52, 2); // 5.2 %
    addWord(frame, status, 2);
    addWord(frame, samples, 4);
    addWord(frame, mode, 2);
    return sealed(frame);
}

constexpr quint64 ticksInPacket = 128'000'000; // 3.2 s of 25 ns

struct PacketText
{
    quint64 start = 0;
    quint64 stop = 0;
    quint16 errors = 0;
    quint16 drz = 324;
    quint16 ax = 32766;
    qint16 first = 0; ///< x counts up from here, y down

    /// Packet \a number of a run that began at tick 0; its samples are numbered in the same way.
    static PacketText numbered(quint64 number)
    {
        PacketText text;
        text.start = number * ticksInPacket;
        text.stop = text.start + ticksInPacket;
        text.first = static_cast<qint16>(number * 32);
        return text;
    }

    QByteArray toBytes() const
    {
        QByteArray bytes;
        for (int i = 0; i < 32; ++i) {
            addWord(bytes, static_cast<quint32>(first + i), 2);
        }
        for (int i = 0; i < 32; ++i) {
            addWord(bytes, static_cast<quint32>(-first - i), 2);
        }
        addWord(bytes, static_cast<quint32>(start & 0xFFFFFFFF), 4);
        addWord(bytes, static_cast<quint32>(stop & 0xFFFFFFFF), 4);
        addWord(bytes, static_cast<quint32>(stop >> 32), 4);
        addWord(bytes, errors, 2);
        addWord(bytes, drz, 2);
        addWord(bytes, ax, 2);
        addWord(bytes, 100, 2); // AY
        return bytes;
    }
};

inline QByteArray packetsAnswer(const QByteArray &packets, int address = 1)
{
    QByteArray frame;
    addWord(frame, static_cast<quint32>(address), 1);
    addWord(frame, 203, 1);
    return sealed(frame + packets);
}

/// Packets \a first … \a first + \a count − 1 of a run without faults.
inline QByteArray packetsAnswer(quint64 first, int count)
{
    QByteArray packets;
    for (int i = 0; i < count; ++i) {
        packets += PacketText::numbered(first + static_cast<quint64>(i)).toBytes();
    }
    return packetsAnswer(packets);
}

} // namespace gorizont::test
