#include "core/analysis/samplestretches.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr double longestDistance = 1.5; ///< of two samples in a stretch, in periods

double medianPeriod(const QList<SeriesBucket> &buckets)
{
    QList<std::chrono::microseconds> periods;
    for (qsizetype i = 1; i < buckets.size(); ++i) {
        periods.append(buckets.at(i).from - buckets.at(i - 1).from);
    }
    if (periods.isEmpty()) {
        return 0;
    }
    const auto middle = periods.begin() + periods.size() / 2;
    std::nth_element(periods.begin(), middle, periods.end());
    return std::chrono::duration<double>(*middle).count();
}

} // namespace

qsizetype SampleStretches::samples() const
{
    qsizetype count = 0;
    for (const QList<double> &stretch : stretches) {
        count += stretch.size();
    }
    return count;
}

SampleStretches sampleStretches(const Series &series)
{
    SampleStretches result;
    const double period = medianPeriod(series.buckets);
    if (!(period > 0)) {
        return result;
    }
    result.rate = 1 / period;
    auto gap = series.gaps.cbegin();
    UtcTime last;
    bool isOpen = false;
    for (const SeriesBucket &bucket : series.buckets) {
        bool isBehindGap = false;
        for (; gap != series.gaps.cend() && gap->from < bucket.from; ++gap) {
            isBehindGap = true;
        }
        const double distance = std::chrono::duration<double>(bucket.from - last).count();
        if (!isOpen || isBehindGap || distance > longestDistance * period) {
            isOpen = false;
        }
        if (bucket.valid == 0) {
            isOpen = false;
            continue;
        }
        if (!isOpen) {
            result.stretches.append(QList<double>());
            isOpen = true;
        }
        result.stretches.last().append(bucket.mean);
        last = bucket.from;
    }
    return result;
}

} // namespace gorizont
