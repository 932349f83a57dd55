#pragma once

#include "core/history/historyformat.h"

namespace gorizont {

/// The text of `_vdata`, the file of the vibration modules, in the manner of `_data` (manual 000, section 6). Pure, and the same in
/// every locale. TAB between fields, CRLF behind a record, no header, a record every TmSave; the file is there only if the site has
/// an L-VIMS. For every one of them, in ascending N, switched off ones included:
///
///     18:33:03 07.02.18⇥3330⇥ 0 0111 0000 0000⇥0⇥1⇥70.71068⇥2⇥1.125395⇥⇥…⇥00000001 00000000 00000001 00000001␍␊
///     time of record    ports status           └ channel 0: state, then type and value of its 8 measurements
///                                                relays, bit 7 first: enabled, error, physical, logical
///
/// That is 70 fields a module: the status word as in `_data`; four channels of 17 fields: CH_STATUS (0 good, 1 the line of the
/// sensor is shorted, 2 it is broken, 65535 no data) and eight pairs of MEAS_TYPE (1…16) and value in the unit of the type;
/// RELE_STATE. Empty: a channel that is not in use or not known, a measurement that is not in use, a value that is not valid.
/// As in `_data` the last values stay when a module does not answer: the status says so.
QByteArray vibrationRecord(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors);

/// Whether \a sensor has a group in a record of `_vdata`.
bool hasVibrationColumns(const SensorConfig &sensor);

} // namespace gorizont
