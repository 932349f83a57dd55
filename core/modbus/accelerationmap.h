#pragma once

#include "core/modbus/unitlayout.h"

namespace gorizont {

/// Unit 6, the accelerations (manual 000, section 10.4). Registers from the base:
///
///     0  1   channel word, 32 bits
///     2 + 5·slot:
///     +0     maximum      short, 0.01 mm/s², modulus of the largest vector
///     +1     direction    short, 0.1°, of that vector, 0…3599
///     +2     RMS X        word, 0.01 mm/s²
///     +3     RMS Y        word, 0.01 mm/s²
///     +4     status       word, section 11.2
///
/// What is not valid keeps its last value, 0 if it never had one; the status says so.
const UnitLayout &accelerationMap();

} // namespace gorizont
