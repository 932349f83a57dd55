#pragma once

#include "core/history/historyformat.h"

namespace gorizont {

/// `ГГГГ_ММ_wdata.txt`, the weather of a month in the manner of `_data`: TAB-separated, CRLF, no header, ASCII but for the codes of
/// parameters, one line every TmSave for each weather station in ascending N, switched-off ones included. Stations differ in their
/// parameters and may not have said them yet, so a line is of one station and names what it holds:
///
///     18:33:03 07.02.18⇥3300⇥7⇥ 0 0101 0000 0000⇥00000005⇥1700003600⇥T1⇥   24.50⇥   24.75⇥…⇥M1⇥    4.75⇥…␍␊
///     time of record    ports N status           digital  rain       code, six values; code, …
///
///     digital   digital inputs, eight hexadecimal digits; empty: the station never answered
///     rain      newest event of precipitation by the clock of the station, seconds since 1970: > 0 it began, < 0 it ended; empty: none
///     code      of a parameter, with its number; then mean, instantaneous value, minimum, maximum, maximum since the last request
///               and standard deviation, each `%8.2f` in the unit of the parameter, empty when it is not there
///
/// The values are those of the last answer, as in `_data`; the status says whether they are of now. Pure.
QByteArray weatherRecord(const QDateTime &local, const QByteArray &channels, const SensorColumns &station);

/// The records of all weather stations among \a sensors, one after the other; empty: there is none.
QByteArray weatherRecords(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors);

} // namespace gorizont
