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

QList<Gap> joined(const QList<Gap> &gaps)
{
    QList<Gap> result;
    for (const Gap &gap : gaps) {
        const bool follows = !result.isEmpty() && !gap.filledFrom.isEmpty() && result.last().to == gap.from
            && result.last().filledFrom == gap.filledFrom && result.last().reason == gap.reason;
        if (follows) {
            result.last().to = gap.to;
        } else {
            result.append(gap);
        }
    }
    return result;
}

QList<TimeSpan> filledParts(const TimeSpan &span, const std::vector<UtcTime> &times, std::chrono::microseconds period)
{
    QList<TimeSpan> parts;
    const auto fill = [&parts](UtcTime from, UtcTime to) {
        if (!parts.isEmpty() && parts.last().to >= from) {
            parts.last().to = to;
        } else if (from < to) {
            parts.append({from, to});
        }
    };
    UtcTime before = span.from;
    bool isValue = false;
    const auto step = [&](UtcTime time) {
        if (time - before <= period * 3 / 2) {
            fill(before, time);
        } else if (isValue) {
            fill(before, before + period);
        }
        before = time;
        isValue = true;
    };
    for (const UtcTime time : times) {
        if (time >= span.from && time < span.to) {
            step(time);
        }
    }
    if (isValue) {
        step(span.to);
    }
    return parts;
}

std::chrono::microseconds usualDistance(const std::vector<UtcTime> &times)
{
    std::vector<std::chrono::microseconds> distances;
    for (std::size_t i = 1; i < times.size(); ++i) {
        distances.push_back(times[i] - times[i - 1]);
    }
    if (distances.empty()) {
        return {};
    }
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
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
