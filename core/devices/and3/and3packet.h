#pragma once

#include <QByteArrayView>
#include <QList>

#include <optional>

namespace gorizont::and3 {

constexpr int packetSamples = 32; ///< of each axis

/// One packet of the ring, 148 bytes, little-endian (spec/and3.md):
///
///     0    int16 × 32  X, raw: a = raw · K       136  uint32  high part of both
///     64   int16 × 32  Y, raw                    140  uint16  errors
///     128  uint32      start, 25 ns, low part    142  uint16  drz
///     132  uint32      stop, 25 ns, low part     144  uint16  AX, then AY
struct Packet
{
    QList<qint16> x; ///< raw units, packetSamples of them
    QList<qint16> y;
    quint64 start = 0; ///< 25 ns; stop of the packet before when nothing is missing between them
    quint64 stop = 0; ///< 25 ns
    quint16 errors = 0;
    quint16 drz = 0; ///< a measure of quality; good packets have 324 or more (observed)
    quint16 ax = 0; ///< 32767 or more: bad (observed)
    quint16 ay = 0;

    bool isValid() const { return errors == 0 && drz >= 324 && ax < 32767; }
    bool operator==(const Packet &) const = default;
};

/// Answer 203, whole, envelope checked. Empty: it does not hold whole packets, one at least.
std::optional<QList<Packet>> parsePackets(QByteArrayView answer);

} // namespace gorizont::and3
