#pragma once

#include "core/archive/integercolumn.h"
#include "core/values/timing.h"

namespace gorizont {

/// Times as integers: microseconds since 1970, UTC.
inline void appendTimes(ArchiveBytes &bytes, std::span<const UtcTime> times)
{
    std::vector<qint64> numbers;
    numbers.reserve(times.size());
    for (const UtcTime time : times) {
        numbers.push_back(time.time_since_epoch().count());
    }
    appendIntegers(bytes, numbers);
}

/// Not good where a time is tens of thousands of years away: sums with it would not fit.
inline std::vector<UtcTime> takeTimes(ArchiveCursor &cursor, quint64 count)
{
    constexpr qint64 farthest = qint64{1} << 60;
    std::vector<UtcTime> times;
    for (const qint64 number : takeIntegers(cursor, count)) {
        if (number < -farthest || number > farthest) {
            cursor.fail();
            return {};
        }
        times.emplace_back(std::chrono::microseconds(number));
    }
    return times;
}

} // namespace gorizont
