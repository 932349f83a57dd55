#pragma once

#include "core/config/serverconfig.h"
#include "core/registry/sensorregistry.h"
#include "tests/ui/samplesite.h"

namespace gorizont::test {

/// A weather station of the sample site's second port (COM9): N 7 at address 1, N 8 at address 2 on request.
inline SensorConfig weatherStation(int index, int number, int address)
{
    SensorConfig sensor;
    sensor.port = 2;
    sensor.index = index;
    sensor.number = number;
    sensor.address = address;
    sensor.isOn = true;
    sensor.type = SensorType::Mk14;
    sensor.model = QStringLiteral("MK-14");
    sensor.name = QStringLiteral("Метео (МК-14)");
    sensor.place = QStringLiteral("Крыша");
    sensor.measuresTemperature = true;
    sensor.measuresWeather = true;
    return sensor;
}

/// A parameter without a valid value.
inline WeatherParameter withoutValue(const WeatherParameter &parameter)
{
    WeatherParameter made;
    made.code = parameter.code;
    made.number = parameter.number;
    made.name = parameter.name;
    made.unit = parameter.unit;
    return made;
}

/// The sample site with one station, N 7, or with two.
inline ServerConfig weatherConfig(int stations = 1)
{
    ServerConfig config = sampleConfig();
    for (int i = 0; i < stations; ++i) {
        config.lines[1].sensors.append(weatherStation(3 + i, 7 + i, 1 + i));
    }
    return config;
}

/// The six parameters of manual 004, section 4.2, as CMD 6 brings them; a wind of 4.1 m/s from 225°.
inline Weather sampleWeather()
{
    const auto parameter = [](char code, const char16_t *name, const char16_t *unit, double mean, double instant,
                              double least, double largest) {
        WeatherParameter made;
        made.code = QLatin1Char(code);
        made.name = QString::fromUtf16(name);
        made.unit = QString::fromUtf16(unit);
        made.mean = mean;
        made.instant = instant;
        made.minimum = least;
        made.maximum = largest;
        return made;
    };
    Weather weather;
    weather.digital = 0x80000011;
    weather.parameters = {
        parameter('U', u"Напряжение питания", u"В", 12.04, 12.1, 11.9, 12.2),
        parameter('T', u"Температура", u"°C", -3.254, -3.2, -3.5, -3.0),
        parameter('P', u"Давление", u"мм рт. ст.", 751.26, 751.3, 751.0, 751.5),
        parameter('H', u"Влажность", u"%", 64.6, 64.0, 63.0, 66.0),
        parameter('A', u"Направление ветра", u"°", 225.4, 230, 190, 260),
        parameter('M', u"Скорость ветра", u"м/с", 4.14, 3.9, 2.0, 6.8)};
    weather.parameters[0].voltage = 4.0127;
    weather.parameters[4].deviation = 11.26;
    weather.parameters[5].deviation = 0.824;
    weather.parameters[5].maxPeriod = 7.35;
    return weather;
}

/// An answer with \a weather, as a МК-14 gives it: a temperature, neither tilt nor acceleration.
inline Reading weatherReading(int number, const Weather &weather, SteadyTime now)
{
    Reading reading;
    reading.number = number;
    reading.time = utcNow();
    reading.isAnswer = true;
    reading.answeredAt = now;
    reading.status = statusbit::TiltInvalid | statusbit::AccelerationInvalid;
    reading.weather = weather;
    const WeatherParameter *temperature = weather.find(weathercode::temperature);
    reading.temperature = temperature ? temperature->mean : std::nullopt;
    if (!reading.temperature) {
        reading.status |= statusbit::TemperatureInvalid;
    }
    return reading;
}

} // namespace gorizont::test
