#pragma once

#include "core/values/sensorconfig.h"

#include <QString>

namespace gorizont {

/// How the page <Вибрация> and the service window of an L-VIMS name what its module measures. Pure.
namespace vibrationnames {

/// `1 acceleration`: the number of MEAS_TYPE and its name; of a type that the manual does not have the number alone.
QString measurement(int type);

/// Of the accelerations of \a sensor, in which its waveforms are.
QString accelerationUnit(const SensorConfig &sensor);

} // namespace vibrationnames

} // namespace gorizont
