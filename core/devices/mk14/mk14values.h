#pragma once

#include "core/devices/mk14/mk14parameters.h"
#include "core/protocol/ackmessages.h"
#include "core/values/weather.h"

namespace gorizont::mk14 {

/// Puts into \a weather what \a answer, to the data command \a command, says (manual 004, section 4.2); what it does not say stays. A
/// parameter behind the end of \a names has the code `?` and its place as number. Values that are no numbers are no values.
/// Parameters that \a answer lacks are dropped.
void put(Weather &weather, int command, const ack::Answer &answer, const QList<ParameterName> &names);

/// The mean of the first parameter with code t or T, °C; empty: there is none, or it is not valid.
std::optional<double> temperatureIn(const Weather &weather);

/// The supply voltage is among the parameters and neither its mean nor its last value is valid.
bool isSupplyBad(const Weather &weather);

} // namespace gorizont::mk14
