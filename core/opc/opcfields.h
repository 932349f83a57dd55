#pragma once

#include "core/opc/opctag.h"
#include "core/values/sensorconfig.h"

namespace gorizont {

/// The fields of \a sensor in the order of its branch: STATE, then DATA. АН-Д3 and ИН-Д3: figure 11.4 of manual 000, the other
/// types by the same rule. \a weather: code, number, name and unit of what a weather station measures. Pure.
QList<OpcField> opcFields(const SensorConfig &sensor, const QList<WeatherParameter> &weather);

/// What a weather station measures by its `Params{i}` (spec/mk14.md, 6): codes parted by commas or blanks, with a number
/// or without; absent or not such a list: U, T, P, H, A, M. Names and units stay empty.
QList<WeatherParameter> weatherParameters(const SensorConfig &sensor);

namespace opcfield {

/// The parts of opcFields(), each in a file of its own.
QList<OpcField> ofTilt(const SensorConfig &sensor);
QList<OpcField> ofVibration();
QList<OpcField> ofWeather(const QList<WeatherParameter> &parameters);

} // namespace opcfield

} // namespace gorizont
