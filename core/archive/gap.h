#pragma once

#include "core/values/series.h"

#include <QDate>
#include <QString>
#include <QTimeZone>

namespace gorizont {

/// Why a sensor gave no valid value. The numbers stand in archives.
enum class GapReason : quint8 {
    SensorOff = 1, ///< On{i}=0
    PortOff = 2, ///< On=0
    PortError = 3, ///< cannot be opened, or was lost
    NoAnswer = 4,
    Crc = 5, ///< wrong check sums
    DeviceFault = 6, ///< it answers, and says that nothing of it is valid
    Service = 7, ///< a service dialog had the port
    ProgramStopped = 8, ///< ended, killed, or not started
    Clock = 9, ///< the clock of the computer was set forward
    Disk = 10, ///< measured, and could not be saved
};

/// One stretch without a valid value of one sensor; from ≤ t < to.
struct Gap
{
    int number = 0; ///< N
    UtcTime from;
    UtcTime to; ///< of one that is open: when it was last looked at
    GapReason reason = GapReason::NoAnswer;
    bool isOpen = false; ///< goes on
    QString source; ///< what the values that fill it were taken from; empty: it is not filled
    bool operator==(const Gap &) const = default;
};

/// \a gaps with everything in \a span marked as filled from \a source: a gap that only partly lies there is divided.
/// What is filled already keeps its source.
QList<Gap> filled(const QList<Gap> &gaps, const TimeSpan &span, const QString &source);

/// How much of a day is there.
struct DayCompleteness
{
    QDate day;
    double share = 1; ///< 0…1 of the time in which the sensor was known
    bool operator==(const DayCompleteness &) const = default;
};

/// One entry for each day, by the clock of \a zone, that \a known touches. \a gaps of one sensor; those that are filled
/// do not count.
QList<DayCompleteness> completeness(const QList<Gap> &gaps, const TimeSpan &known, const QTimeZone &zone);

} // namespace gorizont
