#pragma once

#include "core/values/gap.h"

#include <QList>
#include <QTimeZone>

namespace gorizont {

/// \a gaps with everything in \a span marked as filled from \a source: a gap that only partly lies there is divided.
/// What is filled already keeps its source.
QList<Gap> filled(const QList<Gap> &gaps, const TimeSpan &span, const QString &source);

/// One entry for each day, by the clock of \a zone, that \a known touches. \a gaps of sensor \a number; one that goes on
/// does so until the end of \a known.
QList<DayCompleteness> completeness(int number, const QList<Gap> &gaps, const TimeSpan &known, const QTimeZone &zone);

} // namespace gorizont
