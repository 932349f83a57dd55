#pragma once

#include "core/values/weather.h"

#include <QJsonObject>

namespace gorizont {

/// Adds `digital`, `parameters` (`code`, `number`, `name`, `unit`, and of `mean`, `instant`, `min`, `max`, `voltage`,
/// `voltageInstant`, `maxPeriod`, `deviation` those that are valid) and `events` (`start`, `time`: seconds since 1970) to \a object.
void insertWeather(QJsonObject &object, const Weather &weather);

} // namespace gorizont
