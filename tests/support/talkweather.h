#pragma once

#include "core/values/weather.h"

namespace gorizont::test {

/// With as many decimals as \a expected is written with, so that the two can be compared as text.
QString spelledNumber(const std::optional<double> &value, const QString &expected);

/// What a recording says of a weather station, see talk.h; `?` for a key that does not exist.
QString spelledWeather(const std::optional<Weather> &weather, const QString &key, const QString &expected);

} // namespace gorizont::test
