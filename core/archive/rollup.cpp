#include "core/archive/rollup.h"

#include <algorithm>

namespace gorizont {

namespace {

void join(SeriesBucket &into, const SeriesBucket &from)
{
    into.count += from.count;
    if (from.valid == 0) {
        return;
    }
    if (into.valid == 0) {
        into.minimum = from.minimum;
        into.mean = from.mean;
        into.maximum = from.maximum;
    } else {
        into.minimum = std::min(into.minimum, from.minimum);
        into.maximum = std::max(into.maximum, from.maximum);
        const double share = static_cast<double>(from.valid) / (static_cast<double>(into.valid) + from.valid);
        into.mean += (from.mean - into.mean) * share;
    }
    into.valid += from.valid;
}

/// Joins neighbours of one time.
Buckets joined(Buckets buckets)
{
    Buckets result;
    for (const SeriesBucket &bucket : buckets) {
        if (!result.isEmpty() && result.last().from == bucket.from) {
            join(result.last(), bucket);
        } else {
            result.append(bucket);
        }
    }
    return result;
}

void sortByTime(Buckets &buckets)
{
    const auto isEarlier = [](const SeriesBucket &a, const SeriesBucket &b) { return a.from < b.from; };
    if (!std::is_sorted(buckets.cbegin(), buckets.cend(), isEarlier)) {
        std::stable_sort(buckets.begin(), buckets.end(), isEarlier);
    }
}

} // namespace

Buckets bucketsOf(const std::vector<UtcTime> &times, const ValueColumn &column, std::chrono::microseconds step)
{
    Buckets all;
    UtcTime end;
    double sum = 0;
    const auto finish = [&all, &sum] {
        if (!all.isEmpty() && all.last().valid > 0) {
            all.last().mean = sum / all.last().valid;
        }
        sum = 0;
    };
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (all.isEmpty() || times[i] >= end || times[i] < all.last().from) {
            finish();
            SeriesBucket fresh;
            fresh.from = floored(times[i], step);
            end = fresh.from + step;
            all.append(fresh);
        }
        SeriesBucket &bucket = all.last();
        ++bucket.count;
        if (column.isValid[i]) {
            const double value = column.values[i];
            bucket.minimum = bucket.valid == 0 ? value : std::min(bucket.minimum, value);
            bucket.maximum = bucket.valid == 0 ? value : std::max(bucket.maximum, value);
            sum += value;
            ++bucket.valid;
        }
    }
    finish();
    sortByTime(all);
    return joined(std::move(all));
}

Buckets coarsened(const Buckets &buckets, std::chrono::microseconds step)
{
    Buckets all = buckets;
    for (SeriesBucket &bucket : all) {
        bucket.from = floored(bucket.from, step);
    }
    return joined(std::move(all));
}

Buckets merged(const Buckets &a, const Buckets &b)
{
    if (a.isEmpty() || b.isEmpty()) {
        return a.isEmpty() ? b : a;
    }
    Buckets all = a + b;
    sortByTime(all);
    return joined(std::move(all));
}

} // namespace gorizont
