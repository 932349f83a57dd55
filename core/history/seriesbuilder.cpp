#include "core/history/seriesbuilder.h"

#include <algorithm>
#include <array>

namespace gorizont {

namespace {

using namespace std::chrono_literals;

constexpr std::array<std::chrono::microseconds, 19> steps{500ms, 1s,    2s,    5s, 10s, 15s, 30s, 1min, 2min, 5min,
                                                          10min, 15min, 30min, 1h, 2h,  3h,  6h,  12h,  24h};

} // namespace

SeriesBuilder::SeriesBuilder(SeriesKey key, std::chrono::microseconds period, std::chrono::microseconds step)
    : m_series{key, step, {}, {}}
    , m_period(period)
{
}

void SeriesBuilder::add(UtcTime time, std::optional<double> value)
{
    if (m_last && time <= *m_last) {
        return;
    }
    m_last = time;
    const std::chrono::microseconds step = m_series.step;
    const UtcTime from = step.count() > 0 ? UtcTime(time.time_since_epoch() / step * step) : time;
    QList<SeriesBucket> &buckets = m_series.buckets;
    if (buckets.isEmpty() || buckets.last().from != from) {
        buckets.append({from, 0, 0, 0, 0, 0});
        m_sum = 0;
    }
    SeriesBucket &bucket = buckets.last();
    ++bucket.count;
    if (!value) {
        m_silentSince = m_silentSince.value_or(time);
        return;
    }
    if (m_lastValid && m_silentSince) {
        m_series.gaps.append({*m_silentSince, time});
    } else if (m_lastValid && time - *m_lastValid > 3 * m_period) {
        m_series.gaps.append({*m_lastValid + m_period, time});
    }
    m_lastValid = time;
    m_silentSince.reset();
    bucket.minimum = bucket.valid == 0 ? *value : std::min(bucket.minimum, *value);
    bucket.maximum = bucket.valid == 0 ? *value : std::max(bucket.maximum, *value);
    m_sum += *value;
    ++bucket.valid;
    bucket.mean = m_sum / bucket.valid;
}

Series SeriesBuilder::take(UtcTime from, UtcTime to)
{
    Series series = m_series;
    series.buckets.removeIf([](const SeriesBucket &bucket) { return bucket.valid == 0; });
    if (!m_lastValid) {
        series.gaps = {{from, to}};
        return series;
    }
    const UtcTime first = series.buckets.first().from;
    if (first - from > 3 * m_period && first > from) {
        series.gaps.prepend({from, first});
    }
    if (m_silentSince || to - *m_lastValid > 3 * m_period) {
        series.gaps.append({m_silentSince.value_or(*m_lastValid + m_period), to});
    }
    return series;
}

std::chrono::microseconds stepFor(std::chrono::microseconds span, int width, std::chrono::microseconds period)
{
    std::chrono::microseconds chosen{0};
    for (const std::chrono::microseconds step : steps) {
        if (width > 0 && step >= 2 * period && span / step >= width) {
            chosen = step;
        }
    }
    return chosen;
}

} // namespace gorizont
