#pragma once

#include "core/values/gap.h"

#include <QList>
#include <QTimeZone>

#include <vector>

namespace gorizont {

/// \a gaps with everything in \a span marked as filled from \a source: a gap that only partly lies there is divided.
/// What is filled already keeps its source.
QList<Gap> filled(const QList<Gap> &gaps, const TimeSpan &span, const QString &source);

/// \a gaps, in ascending time, with neighbours that touch, of one reason and one source, joined where they are filled.
QList<Gap> joined(const QList<Gap> &gaps);

/// Which parts of \a span, in which nothing was known, values at \a times (ascending) fill. From one value to the next
/// all is known while they are not farther apart than 1.5 × \a period: a recorder that is asked late or waits for its
/// turn stays within that, and one that leaves a measurement out does not. So it is with the ends of \a span, where the
/// sensor was known. A value without such a neighbour behind it stands for one period.
QList<TimeSpan> filledParts(const TimeSpan &span, const std::vector<UtcTime> &times, std::chrono::microseconds period);

/// The median distance of \a times (ascending); 0: there are not two.
std::chrono::microseconds usualDistance(const std::vector<UtcTime> &times);

/// One entry for each day, by the clock of \a zone, that \a known touches. \a gaps of sensor \a number; one that goes on
/// does so until the end of \a known.
QList<DayCompleteness> completeness(int number, const QList<Gap> &gaps, const TimeSpan &known, const QTimeZone &zone);

} // namespace gorizont
