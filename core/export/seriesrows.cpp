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

SeriesRows::SeriesRows(const QList<Series> &series, UtcTime from, UtcTime to)
    : m_series(series)
    , m_from(from)
    , m_to(to)
    , m_at(series.size(), 0)
{
    m_row.cells.resize(series.size());
}

bool SeriesRows::next()
{
    std::optional<UtcTime> earliest;
    for (qsizetype i = 0; i < m_series.size(); ++i) {
        const QList<SeriesBucket> &buckets = m_series.at(i).buckets;
        qsizetype &at = m_at[i];
        while (at < buckets.size() && (buckets.at(at).valid == 0 || buckets.at(at).from < m_from)) {
            ++at;
        }
        if (at < buckets.size() && buckets.at(at).from < earliest.value_or(m_to)) {
            earliest = buckets.at(at).from;
        }
    }
    if (!earliest) {
        return false;
    }
    m_row.time = *earliest;
    for (qsizetype i = 0; i < m_series.size(); ++i) {
        const QList<SeriesBucket> &buckets = m_series.at(i).buckets;
        const bool isHere = m_at.at(i) < buckets.size() && buckets.at(m_at.at(i)).from == *earliest;
        m_row.cells[i] = isHere ? std::optional(buckets.at(m_at[i]++)) : std::nullopt;
    }
    return true;
}

} // namespace gorizont
