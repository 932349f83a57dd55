#pragma once

#include "core/modbus/unitlayout.h"

namespace gorizont {

/// What unit 1 says of one L-VIMS beside its block: an area of 500 registers, of which one request reads a channel.
///
///     100·I            channel I = 0…3: 0 state, 1 flags, 2 how many measurements are in use
///     100·I + 20 + 10·M    its measurement M = 0…7: 0 type, 1 flags, 2 value, 4 percent, 6 baseline
///     400              relays, bit R of each word: 0 known (all bits), 1 logical, 2 physical, 3 error, 4 enabled
///
/// All is of the last answer. While the module does not answer, or a channel is not in use, its state is 65535 (no data), floats are NaN
/// and all else is 0.
const AreaPart &vibrationAreas();

namespace vibrationarea {
constexpr int channels = 4;
constexpr int channelStep = 100;
constexpr int measurements = 8;
constexpr int firstMeasurement = 20;
constexpr int measurementStep = 10;
constexpr int relays = 400;
} // namespace vibrationarea

/// A bit of the flags of a channel or of a measurement. Bits never change their meaning.
template <typename Thing> struct VibrationBit
{
    int bit; ///< 0…15
    const char *meaning; ///< source text of context RegisterMap
    bool (*isSet)(const Thing &thing);
};
std::span<const VibrationBit<VibrationChannel>> channelFlags();
std::span<const VibrationBit<VibrationMeasurement>> measurementFlags();

} // namespace gorizont
