#pragma once

#include "core/values/gap.h"
#include "core/values/sensorconfig.h"

#include <QColor>
#include <QHash>
#include <QLocale>

namespace gorizont {

/// How much of a day is there, of all chosen sensors together. Value.
struct DayMark
{
    std::chrono::microseconds valid{0};
    std::chrono::microseconds length{0}; ///< 0: nothing is known of the day
    QString toolTip; ///< the day in words, a line for each sensor that lacks most
    bool operator==(const DayMark &) const = default;

    bool isKnown() const { return length.count() > 0; }
    double share() const { return isKnown() ? double(valid.count()) / double(length.count()) : 0; }
};

using DayMarks = QHash<QDate, DayMark>;

/// The days of \a sensors put together.
DayMarks dayMarks(const QList<DayCompleteness> &days, const QList<SensorConfig> &sensors);

/// `100`, `97`: per cent, rounded down, so that 100 says that nothing is missing; `<1` if there is hardly anything.
QString percentText(const DayMark &mark);

/// For the names of months and days: that of the language of the program, whatever the desktop speaks.
QLocale calendarLocale();

/// Colour below the numbers of a day, on a light or a dark background; invalid: nothing is known.
QColor dayColour(const DayMark &mark, bool isDark);

} // namespace gorizont
