#pragma once

#include "core/values/journalentry.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"
#include "core/values/sensorconfig.h"

#include <QByteArray>
#include <QDateTime>
#include <QTimeZone>

namespace gorizont {

/// The text of the history files: manual 000, section 6; spec/gorizont.md, sections 3 and 4. Pure, and the same in
/// every locale.
///
///     18:33:03 07.02.18⇥3300⇥  -264.0⇥ -6644.6⇥⇥     0.0⇥ 0 0011 0011 1000␍␊
///     time of record    ports X″       Y″      T° heater % status, the last five for every sensor

/// One sensor and the last that is known of it: one group of columns.
struct SensorColumns
{
    SensorConfig config;
    Reading reading;
};

enum class MonthFile : quint8 { Data, Acceleration, Log, Weather };

/// \a time as the clock on the wall of \a zone shows it; an invalid zone is that of the computer.
QDateTime localTime(UtcTime time, const QTimeZone &zone);

/// One digit 0…3 a port, port 1 rightmost, at least four digits; a slot without a port is 3 (in Modbus it is 0).
QByteArray channelDigits(const QList<LineStatus> &lines);

/// `%8.{decimals}f`, the same in every locale; empty: there is no value, or it is not a number.
QByteArray historyField(const std::optional<double> &value, int decimals);

/// `18:33:03 07.02.18⇥3300`: how the records of measured values begin.
QByteArray recordBeginning(const QDateTime &local, const QByteArray &channels);

/// The code in decimal, then the other bits in groups of four: `10 0000 0001 0100`.
QByteArray statusDigits(quint16 word);

/// One record of `_data`, CRLF included: every sensor in \a sensors that measures tilt, in the order given. A value that
/// never was leaves its field empty, and so does one that is not a number.
QByteArray dataRecord(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors);

/// One record of `_adata`, CRLF included: every sensor in \a sensors that measures accelerations.
QByteArray accelerationRecord(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors);

/// One record of `_log`, CRLF included. Line breaks within the text become blanks: one event is one line.
QString logRecord(const JournalEntry &entry, const QTimeZone &zone);

/// `2018_02_data.txt`
QString monthFileName(QDate month, MonthFile file);

/// `16_03_29_22_46_09_1X.wrd`; \a start is the time of the first sample, \a axis is X or Y.
QString sampleFileName(const QDateTime &start, int number, QChar axis);

} // namespace gorizont
