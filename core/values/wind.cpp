#include "core/values/wind.h"

#include <algorithm>

namespace gorizont {

Wind windOf(const Weather &weather)
{
    Wind wind;
    if (const WeatherParameter *speed = weather.find(weathercode::windSpeed)) {
        wind.speed = speed->mean;
        // An empty one is smaller than any other.
        wind.maximum = std::max(speed->maximum, speed->maxPeriod);
        wind.deviation = speed->deviation;
    }
    if (const WeatherParameter *direction = weather.find(weathercode::windDirection)) {
        wind.direction = direction->mean;
        wind.directionDeviation = direction->deviation;
    }
    return wind;
}

std::optional<double> meanOf(const Weather &weather, QChar code)
{
    const WeatherParameter *parameter = weather.find(code);
    return parameter ? parameter->mean : std::nullopt;
}

} // namespace gorizont
