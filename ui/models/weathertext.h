#pragma once

#include "core/registry/sensorregistry.h"

#include <QString>

namespace gorizont {

/// What a weather station measures that is to be believed now; null: nothing, for it is not polled, does not answer, or is in service.
/// Lives as long as \a sensor is left alone.
const Weather *shownWeather(const SensorRegistry::Sensor &sensor, LineState line);

/// The mean wind along the axes of the map: U > 0 blows towards the east, V > 0 towards the north, as meteorology has it (the
/// manual says nothing). A direction is where the wind comes from, so U = −s·sin A, V = −s·cos A. s is W, the modulus of the mean vector,
/// where the station has it, else M.
struct WindComponents
{
    double u = 0; ///< m/s
    double v = 0; ///< m/s

    static std::optional<WindComponents> of(const Weather &weather); ///< empty: speed or direction is not valid
};

/// How the values of a weather station are written. Pure.
namespace weathertext {

QString rumb(int sector); ///< `С`, `ССВ`, …: of windrose's sixteen, from the north clockwise
QString rumbOf(double degrees);
QString direction(std::optional<double> degrees); ///< `225° ЮЗ`

QString components(const std::optional<WindComponents> &wind); ///< `+1.2 -3.4`

QString code(const WeatherParameter &parameter); ///< `T1`

/// A value of the parameter \a parameter with as many digits as manual 004, section 4.2, gives its code; `—` without one.
QString value(const WeatherParameter &parameter, std::optional<double> value);
QString deviation(const WeatherParameter &parameter); ///< with one digit more
QString voltage(std::optional<double> value);

QString digital(quint32 word); ///< `0x00000011 (0, 4)`: the word and the inputs that are on

/// Wind and temperature in a line, for tool tips. Empty: none of them is valid.
QString summary(const Weather &weather);

} // namespace weathertext

} // namespace gorizont
