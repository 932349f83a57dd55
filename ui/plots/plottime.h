#pragma once

#include "core/values/timing.h"

#include <cmath>

namespace gorizont {

/// The axis of time counts seconds since 1970, as QCustomPlot wants it; a microsecond is still told apart.
inline double toKey(UtcTime time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// The nearest microsecond; a key is any finite number within ± 200,000 years.
inline UtcTime toTime(double key)
{
    return UtcTime(std::chrono::round<std::chrono::microseconds>(std::chrono::duration<double>(key)));
}

} // namespace gorizont
