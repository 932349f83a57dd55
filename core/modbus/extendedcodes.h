#pragma once

#include "core/modbus/unitstate.h"

#include <span>

namespace gorizont {

/// A bit of the registers `flags` and `quantities` of unit 1. Bits never change their meaning.
struct SlotBit
{
    int bit; ///< 0…15
    const char *meaning; ///< source text of context RegisterMap
    bool (*isSet)(const SlotState &state);
};
std::span<const SlotBit> extendedFlags();
std::span<const SlotBit> extendedQuantities();

/// The register `type` of unit 1. Codes never change.
struct TypeCode
{
    SensorType type;
    int code;
    const char *models; ///< source text of context RegisterMap
};
std::span<const TypeCode> extendedTypes();

/// What is there and valid now.
bool hasTilt(const SlotState &state);
bool hasTemperature(const SlotState &state);
bool hasAcceleration(const SlotState &state);
/// A weather station answers; its values may be valid or not, each for itself.
bool hasWeather(const SlotState &state);

} // namespace gorizont
