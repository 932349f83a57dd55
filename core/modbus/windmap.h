#pragma once

#include "core/modbus/unitlayout.h"

namespace gorizont {

/// Unit 4, the wind of weather stations. Manual 000 does not have it; it begins and is read like units 3 and 6: function 04, all
/// numbers low byte first. It is there only if the site has a weather station. Registers from the base:
///
///     0  1   channel word, 32 bits
///     2 + 7·slot, 14 bytes a station:
///     +0     speed                   word, 0.01 m/s, mean
///     +1     direction               word, 0.1°, mean, 0…3599
///     +2     maximum                 word, 0.01 m/s
///     +3     its direction           word, 0.1°; 0: stations do not say it
///     +4     deviation of the speed  word, 0.01 m/s
///     +5     deviation of the direction  word, 0.01°
///     +6     status                  word, section 11.2
///
/// The status word has no bit for the wind. Of a station that does not answer the last values stay, 0 if there never were any, and the
/// status says so; what an answering station has not got is FFFFh, as its own FF FF FF FF.
const UnitLayout &windMap();

} // namespace gorizont
