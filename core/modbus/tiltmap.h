#pragma once

#include "core/modbus/unitlayout.h"

namespace gorizont {

/// Unit 3, the angles (manual 000, section 10.3). Registers from the base:
///
///     0  1   channel word, 32 bits
///     2 + 4·slot:
///     +0     X            short, 0.001°
///     +1     Y            short, 0.001°
///     +2     temperature  short, 0.01 °C
///     +3     status       word, section 11.2
///
/// What is not valid keeps its last value, 0 if it never had one; the status says so.
const UnitLayout &tiltMap();

} // namespace gorizont
