#include "core/export/seriesrows.h"

#include <QDateTime>

#include <algorithm>

namespace gorizont {

namespace {

QDate dayOf(UtcTime time, const QTimeZone &zone)
{
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    return zone.isValid() ? QDateTime::fromMSecsSinceEpoch(ms, zone).date() : QDateTime::fromMSecsSinceEpoch(ms).date();
}

UtcTime beginOfDay(QDate day, const QTimeZone &zone)
{
    const QDateTime begin = zone.isValid() ? day.startOfDay(zone) : day.startOfDay();
    return UtcTime(std::chrono::milliseconds(begin.toMSecsSinceEpoch()));
}

void add(SeriesBucket &sum, const SeriesBucket &bucket)
{
    const double valid = double(sum.valid) + bucket.valid;
    sum.minimum = std::min(sum.minimum, bucket.minimum);
    sum.maximum = std::max(sum.maximum, bucket.maximum);
    sum.mean += (bucket.mean - sum.mean) * (bucket.valid / valid);
    sum.count += bucket.count;
    sum.valid += bucket.valid;
}

} // namespace

UtcTime beginOf(UtcTime time, ExportEvery every, const QTimeZone &zone)
{
    switch (every) {
    case ExportEvery::Reading: return time;
    case ExportEvery::Minute: return std::chrono::floor<std::chrono::minutes>(time);
    case ExportEvery::Hour: return std::chrono::floor<std::chrono::hours>(time);
    case ExportEvery::Day: break;
    }
    return beginOfDay(dayOf(time, zone), zone);
}

UtcTime nextAfter(UtcTime time, ExportEvery every, const QTimeZone &zone)
{
    switch (every) {
    case ExportEvery::Reading: return time;
    case ExportEvery::Minute: return beginOf(time, every, zone) + std::chrono::minutes(1);
    case ExportEvery::Hour: return beginOf(time, every, zone) + std::chrono::hours(1);
    case ExportEvery::Day: break;
    }
    return beginOfDay(dayOf(time, zone).addDays(1), zone);
}

QList<SeriesBucket> rolledUp(const QList<SeriesBucket> &buckets, ExportEvery every, const QTimeZone &zone)
{
    QList<SeriesBucket> result;
    UtcTime end;
    for (const SeriesBucket &bucket : buckets) {
        if (bucket.valid == 0) {
            continue;
        }
        if (!result.isEmpty() && bucket.from < end) {
            add(result.last(), bucket);
            continue;
        }
        result << bucket;
        result.last().from = beginOf(bucket.from, every, zone);
        end = nextAfter(bucket.from, every, zone);
    }
    return result;
}

QList<SeriesRow> rowsOf(const QList<Series> &series, UtcTime from, UtcTime to)
{
    QList<SeriesRow> rows;
    QList<qsizetype> at(series.size(), 0);
    while (true) {
        std::optional<UtcTime> earliest;
        for (qsizetype i = 0; i < series.size(); ++i) {
            const QList<SeriesBucket> &buckets = series.at(i).buckets;
            while (at[i] < buckets.size() && (buckets.at(at[i]).valid == 0 || buckets.at(at[i]).from < from)) {
                ++at[i];
            }
            if (at[i] < buckets.size() && buckets.at(at[i]).from < earliest.value_or(to)) {
                earliest = buckets.at(at[i]).from;
            }
        }
        if (!earliest) {
            return rows;
        }
        SeriesRow row{*earliest, {}};
        row.cells.resize(series.size());
        for (qsizetype i = 0; i < series.size(); ++i) {
            const QList<SeriesBucket> &buckets = series.at(i).buckets;
            if (at[i] < buckets.size() && buckets.at(at[i]).from == *earliest) {
                row.cells[i] = buckets.at(at[i]++);
            }
        }
        rows << row;
    }
}

} // namespace gorizont
