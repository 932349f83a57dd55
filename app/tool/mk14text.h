#pragma once

#include "core/values/weather.h"

namespace gorizont::tool {

/// One parameter a line with what is valid of it, then the digital inputs and the events.
QString textOf(const Weather &weather);

} // namespace gorizont::tool
