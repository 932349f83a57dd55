#include "core/analysis/seriesstatistics.h"

#include <algorithm>

namespace gorizont {

namespace {

using Days = std::chrono::duration<double, std::chrono::days::period>;

bool beginsBefore(const SeriesBucket &bucket, UtcTime time)
{
    return bucket.from < time;
}

/// Weighted sums about the first moment and value, so that nothing is lost to the size of the numbers.
class Line
{
public:
    void add(double day, double value, double weight)
    {
        if (m_weight == 0) {
            m_origin = value;
        }
        value -= m_origin;
        m_weight += weight;
        const double step = day - m_day;
        m_day += step * weight / m_weight;
        m_value += (value - m_value) * weight / m_weight;
        m_squares += weight * step * (day - m_day);
        m_products += weight * step * (value - m_value);
    }
    double mean() const { return m_origin + m_value; }
    double slope() const { return m_squares > 0 ? m_products / m_squares : 0; }

private:
    double m_origin = 0;
    double m_weight = 0;
    double m_day = 0;
    double m_value = 0;
    double m_squares = 0;
    double m_products = 0;
};

/// How far \a time is from the stretch of \a bucket.
std::chrono::microseconds distance(const SeriesBucket &bucket, std::chrono::microseconds step, UtcTime time)
{
    return time < bucket.from ? bucket.from - time : std::max(time - bucket.from - step, std::chrono::microseconds(0));
}

} // namespace

std::optional<SeriesStatistics> statistics(const Series &series, UtcTime from, UtcTime to)
{
    const QList<SeriesBucket> &buckets = series.buckets;
    const auto begin = std::lower_bound(buckets.cbegin(), buckets.cend(), from, beginsBefore);
    SeriesStatistics result;
    Line line;
    for (auto bucket = begin; bucket != buckets.cend() && bucket->from < to; ++bucket) {
        result.readings += bucket->count;
        if (bucket->valid == 0) {
            continue;
        }
        const bool isFirst = result.valid == 0;
        result.first = isFirst ? bucket->mean : result.first;
        result.last = bucket->mean;
        result.minimum = isFirst ? bucket->minimum : std::min(result.minimum, bucket->minimum);
        result.maximum = isFirst ? bucket->maximum : std::max(result.maximum, bucket->maximum);
        result.valid += bucket->valid;
        line.add(Days(bucket->from - from).count(), bucket->mean, bucket->valid);
    }
    if (result.valid == 0) {
        return {};
    }
    result.mean = line.mean();
    result.slope = line.slope();
    result.completeness = completeness(series.gaps, from, to);
    return result;
}

double completeness(const QList<TimeSpan> &gaps, UtcTime from, UtcTime to)
{
    if (from >= to) {
        return 0;
    }
    std::chrono::microseconds missing{0};
    UtcTime counted = from;
    for (const TimeSpan &gap : gaps) {
        const UtcTime begin = std::max(gap.from, counted);
        const UtcTime end = std::min(gap.to, to);
        if (begin < end) {
            missing += end - begin;
            counted = end;
        }
    }
    return 1 - static_cast<double>(missing.count()) / static_cast<double>((to - from).count());
}

std::optional<double> valueAt(const Series &series, UtcTime time)
{
    const auto isHere = [time](const TimeSpan &gap) { return gap.from <= time && time < gap.to; };
    const QList<SeriesBucket> &buckets = series.buckets;
    if (buckets.isEmpty() || time < buckets.first().from || time > buckets.last().from + series.step
        || std::any_of(series.gaps.cbegin(), series.gaps.cend(), isHere)) {
        return {};
    }
    auto next = std::lower_bound(buckets.cbegin(), buckets.cend(), time, beginsBefore);
    auto nearest = next;
    if (next == buckets.cend()
        || (next != buckets.cbegin()
            && distance(*(next - 1), series.step, time) < distance(*next, series.step, time))) {
        nearest = next - 1;
    }
    return nearest->valid > 0 ? std::optional(nearest->mean) : std::nullopt;
}

} // namespace gorizont
