#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gorizont::bench {

/// What every server under test answers: unit 3 with 30 tilt sensors, function 04 from register 0.
/// Written from manual 000, section 10.3, and not with the program's own encoder: all numbers low byte first, the word of
/// channels (zeros, all is well), then X and Y in thousandths of a degree, °C × 100 and the status of one sensor after
/// the other.
constexpr int unit = 3;
constexpr int sensorCount = 30;
constexpr int registerCount = 2 + 4 * sensorCount; // 122
constexpr std::size_t payloadSize = std::size_t{2} * registerCount; ///< bytes
constexpr std::size_t requestSize = 12; ///< bytes
constexpr std::size_t answerSize = 9 + payloadSize; ///< bytes

struct TiltOfSensor
{
    int x; ///< 0.001°
    int y; ///< 0.001°
};

/// \a sensor from 0. Both bytes of every value differ from sensor to sensor or from axis to axis.
constexpr TiltOfSensor tiltOf(int sensor)
{
    return {257 * sensor + 1, -300 * sensor - 7};
}

/// The registers as they go over the wire.
constexpr std::array<std::uint8_t, payloadSize> payload()
{
    std::array<std::uint8_t, payloadSize> bytes{};
    const auto write = [&bytes](int at, int value) {
        bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value & 0xFF);
        bytes[static_cast<std::size_t>(at) + 1] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
    };
    for (int sensor = 0; sensor < sensorCount; ++sensor) {
        write(4 + 8 * sensor, tiltOf(sensor).x);
        write(6 + 8 * sensor, tiltOf(sensor).y);
    }
    return bytes;
}

/// The same as numbers: the value of register \a index.
constexpr std::uint16_t payloadRegister(int index)
{
    const auto bytes = payload();
    const auto at = std::size_t{2} * static_cast<std::size_t>(index);
    return static_cast<std::uint16_t>(bytes[at] << 8 | bytes[at + 1]);
}

} // namespace gorizont::bench
