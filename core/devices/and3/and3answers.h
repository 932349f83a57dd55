#pragma once

#include "core/devices/and3/and3protocol.h"
#include "core/values/reading.h"

#include <array>
#include <optional>

/// What the data of the answers mean, pure (spec/and3.md); the packets of the ring have a file of their own.
namespace gorizont::and3 {

/// Answer 201 (18 bytes, little-endian):
///
///     0  int16   X, 1/8 arc-second           8   uint16  heater power, 1/10 %
///     2  int16   Y, 1/8 arc-second           10  uint16  raw status, see conditionsOf()
///     4  int16   temperature, 1/250 °C       12  uint32  measurements (samples) since the start
///     6  uint16  fan frequency, 1/8 s⁻¹      16  uint16  mode word
struct ComplexRead
{
    Tilt tilt; ///< arc-seconds
    double temperature = 0; ///< °C
    double fanFrequency = 0; ///< 1/s
    double heaterPower = 0; ///< %
    quint16 rawStatus = 0;
    quint32 samples = 0; ///< 10 a second
    quint16 rawMode = 0;

    bool isRecording() const { return !(rawMode & (1 << static_cast<int>(ModeBit::RecordingStopped))); }
    bool operator==(const ComplexRead &) const = default;
};

/// Bits of the raw status that say what of the answer is there.
namespace statusbit {
constexpr quint16 RebootAcknowledged = 1 << 0;
constexpr quint16 TiltReady = 1 << 1;
constexpr quint16 TemperatureReady = 1 << 2;
constexpr quint16 FanReady = 1 << 3;
} // namespace statusbit

/// Bit 0 set means acknowledged: the document's table says the opposite, but a healthy sensor shows
/// `0010 0100 0000 1111` (observed). Whether fan and thermostat count is not decided here.
Conditions conditionsOf(quint16 rawStatus);

/// Answer 36 with InformationKind::Firmware.
struct Firmware
{
    int version = 0;
    int subVersion = 0;
    int build = 0;
    bool operator==(const Firmware &) const = default;
};

/// All of these take the whole answer, envelope checked; empty: its length is not that of this answer.
std::optional<ComplexRead> parseComplexRead(QByteArrayView answer);
std::optional<quint32> parseInformation(QByteArrayView answer);
std::optional<Firmware> parseFirmware(QByteArrayView answer);

/// Answer 221.
constexpr std::size_t configurationSize = 32;
constexpr std::size_t addressIndex = 4; ///< byte 5 is the inner transducer's (the flow chart errs, the table is right)
using Configuration = std::array<quint8, configurationSize>;

std::optional<Configuration> parseConfiguration(QByteArrayView answer);

} // namespace gorizont::and3
