#pragma once

#include "core/values/weather.h"

namespace gorizont {

/// The wind of a station: that of its first sensor of direction and its first of speed. What is not valid is empty.
struct Wind
{
    std::optional<double> speed; ///< m/s, mean of the modulus
    std::optional<double> direction; ///< degrees, mean
    std::optional<double> maximum; ///< m/s, the larger of the maxima of the last turns, which cover different times
    std::optional<double> deviation; ///< σ of the speed, m/s
    std::optional<double> directionDeviation; ///< σ of the direction, degrees
    bool operator==(const Wind &) const = default;
};

Wind windOf(const Weather &weather);

/// The mean of the first parameter with \a code; empty: there is none, or it is not valid.
std::optional<double> meanOf(const Weather &weather, QChar code);

} // namespace gorizont
