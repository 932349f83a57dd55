#pragma once

#include "core/values/series.h"

#include <optional>

namespace gorizont {

/// Makes a series of values that come in ascending time. Pure.
class SeriesBuilder
{
public:
    /// \a period: how far apart two values stand; what is three times as far apart has a gap between.
    /// \a step: length of a bucket, 0: full rate.
    SeriesBuilder(SeriesKey key, std::chrono::microseconds period, std::chrono::microseconds step);

    /// Empty: the sensor said nothing valid then, and a gap begins. What is earlier than the last value is ignored.
    void add(UtcTime time, std::optional<double> value);

    /// What \a from … \a to holds; where nothing begins or ends is a gap.
    Series take(UtcTime from, UtcTime to);

private:
    Series m_series;
    std::chrono::microseconds m_period;
    double m_sum = 0; ///< of the valid values of the last bucket
    std::optional<UtcTime> m_last; ///< when something was added
    std::optional<UtcTime> m_lastValid;
    std::optional<UtcTime> m_silentSince; ///< the first invalid one since
};

/// The coarsest round step that gives at least \a width buckets in \a span; 0, full rate: no step of at least two periods
/// does, or \a width is 0.
std::chrono::microseconds stepFor(std::chrono::microseconds span, int width, std::chrono::microseconds period);

} // namespace gorizont
