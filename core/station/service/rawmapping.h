#pragma once

#include "core/station/sources/rawsample.h"
#include "core/station/stationconfig.h"
#include "core/station/stationpipeline.h"

namespace gorizont::station {

/// The channel (0…) that the first place in the strings of a board is: 0; of ACK.FWL beside an ACK.LCD: 32.
int firstChannelOf(const StationConfig &config, ObjectKind board);

/// What the sources measured, by parameter instead of by channel: \a time and clock are left to the caller. Parameters An and Mn that
/// no board measures are the n-th wind sensor. Pure.
RawSecond secondOf(const StationConfig &config, const RawSample &sample);

} // namespace gorizont::station
