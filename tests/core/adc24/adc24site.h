#pragma once

#include "core/adc24/adc24config.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"

namespace gorizont::test {

/// Accelerometer number 7, axis X, a ring of four packets.
inline Adc24Config adc24Site()
{
    Adc24Config config;
    config.port = 0;
    config.number = 7;
    config.ringPackets = 4;
    config.desk.bind = QStringLiteral("127.0.0.1");
    return config;
}

inline SampleBlock sampleBlock(const QList<qint16> &x, bool followsPrevious = true)
{
    SampleBlock block;
    block.number = 7;
    block.followsPrevious = followsPrevious;
    block.x = x;
    block.y = QList<qint16>(x.size(), -1);
    return block;
}

/// 1, −1, 256, −2, 32767, −32768; little-endian 0100 FFFF 0001 FEFF FF7F 0080.
inline SampleBlock sixSamples()
{
    return sampleBlock({1, -1, 256, -2, 32767, -32768});
}

inline Reading statusReading(quint16 status, int number = 7)
{
    Reading reading;
    reading.number = number;
    reading.status = status;
    return reading;
}

} // namespace gorizont::test
