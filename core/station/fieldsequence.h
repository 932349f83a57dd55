#pragma once

#include "core/station/stationtext.h"

namespace gorizont::station {

/// The values of ACK.LCD, ACK.FWL and ACK.GAM: a list of values of a known length. When there are at least \a count lines, each line
/// holds one, its first field, and the rest is comment; else all fields of all lines are values. Each is a line of one field.
QList<Record> valuesOf(const QList<Record> &records, qsizetype count);

} // namespace gorizont::station
