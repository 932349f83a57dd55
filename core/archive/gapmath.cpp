#include "core/archive/gapmath.h"

#include <QDateTime>

#include <algorithm>

namespace gorizont {

namespace {

UtcTime startOf(QDate day, const QTimeZone &zone)
{
    return UtcTime(std::chrono::milliseconds(day.startOfDay(zone).toMSecsSinceEpoch()));
}

QDate dayOf(UtcTime time, const QTimeZone &zone)
{
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    return QDateTime::fromMSecsSinceEpoch(ms, zone).date();
}

/// The parts of \a span that unfilled gaps cover, each moment once.
std::chrono::microseconds missingIn(const QList<Gap> &sorted, const TimeSpan &span)
{
    std::chrono::microseconds missing{0};
    UtcTime done = span.from;
    for (const Gap &gap : sorted) {
        const UtcTime from = std::max(gap.from, done);
        const UtcTime to = std::min(gap.to.value_or(span.to), span.to);
        if (gap.filledFrom.isEmpty() && to > from) {
            missing += to - from;
            done = to;
        }
    }
    return missing;
}

} // namespace

QList<Gap> filled(const QList<Gap> &gaps, const TimeSpan &span, const QString &source)
{
    QList<Gap> result;
    for (const Gap &gap : gaps) {
        const UtcTime from = std::max(gap.from, span.from);
        const UtcTime to = std::min(gap.to.value_or(span.to), span.to);
        if (from >= to || !gap.filledFrom.isEmpty()) {
            result.append(gap);
            continue;
        }
        Gap part = gap;
        if (gap.from < from) {
            part.to = from;
            result.append(part);
        }
        part.from = from;
        part.to = to;
        part.filledFrom = source;
        result.append(part);
        if (!gap.to || to < *gap.to) {
            part = gap;
            part.from = to;
            result.append(part);
        }
    }
    return result;
}

QList<DayCompleteness> completeness(int number, const QList<Gap> &gaps, const TimeSpan &known, const QTimeZone &zone)
{
    QList<Gap> sorted = gaps;
    std::sort(sorted.begin(), sorted.end(), [](const Gap &a, const Gap &b) { return a.from < b.from; });
    QList<DayCompleteness> days;
    if (known.from >= known.to) {
        return days;
    }
    for (QDate day = dayOf(known.from, zone); startOf(day, zone) < known.to; day = day.addDays(1)) {
        const TimeSpan span{
            std::max(startOf(day, zone), known.from), std::min(startOf(day.addDays(1), zone), known.to)};
        if (span.from < span.to) {
            const auto length = span.to - span.from;
            days.append({number, day, length - missingIn(sorted, span), length});
        }
    }
    return days;
}

} // namespace gorizont
