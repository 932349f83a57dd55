#pragma once

#include "core/values/timing.h"

#include <QtGlobal>

#include <variant>

namespace gorizont {

/// The quality byte of OPC Data Access, those of its values that are told here (spec/opc.md, Tags).
enum class OpcQuality : quint8 {
    NotConnected = 0x08, ///< the port of the sensor cannot be opened or is gone
    SensorFailure = 0x10, ///< the sensor answers and calls its transducer faulty
    LastKnown = 0x14, ///< the sensor does not answer; the value is the last one it gave
    CommFailure = 0x18, ///< the sensor does not answer and has never given a value
    OutOfService = 0x1C, ///< switched off, under service, or not measured by this sensor
    WaitingForInitialData = 0x20, ///< nothing to give yet
    Good = 0xC0,
};

/// Nothing, while there never was a value.
using OpcValue = std::variant<std::monostate, bool, double>;

/// What a tag is worth at one moment.
struct OpcSample
{
    OpcValue value;
    OpcQuality quality = OpcQuality::WaitingForInitialData;
    UtcTime time; ///< of the reading that says so

    bool operator==(const OpcSample &) const = default;
};

} // namespace gorizont
