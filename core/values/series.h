#pragma once

#include "core/values/quantity.h"
#include "core/values/timing.h"

#include <QFuture>
#include <QList>

#include <compare>
#include <functional>

namespace gorizont {

/// One curve: a quantity of a sensor.
struct SeriesKey
{
    int number = 0; ///< N, the sensor
    Quantity quantity = Quantity::TiltX;
    auto operator<=>(const SeriesKey &) const = default;
};

/// What is known of a stretch of time. At full rate it is one value: minimum = mean = maximum, both counts are 1.
struct SeriesBucket
{
    UtcTime from; ///< the stretch ends where the next bucket begins, or after Series::step
    double minimum = 0; ///< in the unit of the quantity
    double mean = 0;
    double maximum = 0;
    quint32 count = 0; ///< readings in the stretch
    quint32 valid = 0; ///< those of them that brought the quantity; 0: the three values mean nothing
    bool operator==(const SeriesBucket &) const = default;
};

/// A stretch in which a sensor gave no valid value; from ≤ t < to.
struct TimeSpan
{
    UtcTime from;
    UtcTime to;
    bool operator==(const TimeSpan &) const = default;
};

/// What a source knows of one curve.
struct Series
{
    SeriesKey key;
    std::chrono::microseconds step{0}; ///< length of a bucket; 0: full rate
    QList<SeriesBucket> buckets; ///< in ascending time; those of no valid value may be left out
    QList<TimeSpan> gaps; ///< in ascending time; a curve is never drawn across one
    bool operator==(const Series &) const = default;
};

struct SeriesQuery
{
    QList<SeriesKey> keys;
    UtcTime from;
    UtcTime to; ///< from ≤ t < to
    int width =
        0; ///< pixels: the source answers with the coarsest step that gives at least so many buckets; 0: full rate
    bool operator==(const SeriesQuery &) const = default;
};

/// Answers a query with one series for each key, in the order of the keys; the future is finished in another thread,
/// or cancelled when the source has gone. Whoever asks owns nothing and may forget the future.
using SeriesSource = std::function<QFuture<QList<Series>>(const SeriesQuery &query)>;

} // namespace gorizont
