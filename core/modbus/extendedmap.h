#pragma once

#include "core/modbus/unitlayout.h"

namespace gorizont {

/// Unit 1, the extended map: every sensor of every type in full precision, for clients that need not be compatible with
/// manual 000. Functions 03 and 04. High byte and high word first. Version 1 of the layout:
///
///     0 …        head: what the map is and where it lies, clocks, channel word, counts by state
///     100 + 4·slot     directory: N, status and flags of that slot, to find a sensor and to watch many at once
///     3000 + 100·slot  block of a sensor, read with one request
///
/// Slots follow the rule of units 3 and 6 (ModbusPacking), so that a site has one order everywhere: ByType in ascending
/// N, switched-off sensors included; ByNumber slot N − 1. Both the directory and the first register of a block name the
/// sensor, so a client that looks there never takes one sensor for another after the ini has changed.
///
/// Addresses do not move when the map grows. What is not in the tables is reserved and reads 0; new fields take reserved
/// registers and leave `version` as it is, which changes only if a field changes its place or meaning. Kept free in a
/// block: 72…79 displacement, 94…99 where to find what has more values than a block holds
/// (the channels of L-VIMS); in the head 40…99.
///
/// A float without a value, or with one that is not valid now, is NaN; an integer is 0 and a flag says so. (Units 3 and 6
/// keep the last value instead, as the manual wants.)
const UnitLayout &extendedMap();

} // namespace gorizont
