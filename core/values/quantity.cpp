#include "core/values/quantity.h"

#include "core/values/statusword.h"
#include "core/values/wind.h"

namespace gorizont {

namespace {

std::optional<double> accelerationOf(const AccelStatistics &acceleration, Quantity quantity)
{
    switch (quantity) {
    case Quantity::AccelMaximum: return acceleration.maximum;
    case Quantity::AccelMaximumX: return acceleration.maximumX;
    case Quantity::AccelMaximumY: return acceleration.maximumY;
    case Quantity::AccelRms: return acceleration.rms;
    case Quantity::AccelRmsX: return acceleration.rmsX;
    case Quantity::AccelRmsY: return acceleration.rmsY;
    case Quantity::AccelDirection: return acceleration.direction;
    default: return {};
    }
}

std::optional<double> weatherOf(const Weather &weather, Quantity quantity)
{
    switch (quantity) {
    case Quantity::WindSpeed: return windOf(weather).speed;
    case Quantity::WindDirection: return windOf(weather).direction;
    case Quantity::WindMaximum: return windOf(weather).maximum;
    case Quantity::Pressure: return meanOf(weather, weathercode::pressure);
    case Quantity::Humidity: return meanOf(weather, weathercode::humidity);
    default: return {};
    }
}

} // namespace

const QList<Quantity> &readingQuantities()
{
    static const QList<Quantity> all{
        Quantity::TiltX,         Quantity::TiltY,         Quantity::Temperature,   Quantity::HeaterPower,
        Quantity::FanFrequency,  Quantity::AccelMaximum,  Quantity::AccelMaximumX, Quantity::AccelMaximumY,
        Quantity::AccelRms,      Quantity::AccelRmsX,     Quantity::AccelRmsY,     Quantity::AccelDirection,
        Quantity::DisplacementX, Quantity::DisplacementY, Quantity::WindSpeed,     Quantity::WindDirection,
        Quantity::WindMaximum,   Quantity::Pressure,      Quantity::Humidity,
    };
    return all;
}

std::optional<double> valueOf(const Reading &reading, Quantity quantity)
{
    switch (quantity) {
    case Quantity::TiltX:
    case Quantity::TiltY:
        if (!reading.tilt || !isTiltValid(reading.status)) {
            return {};
        }
        return quantity == Quantity::TiltX ? reading.tilt->x : reading.tilt->y;
    case Quantity::Temperature: return isTemperatureValid(reading.status) ? reading.temperature : std::nullopt;
    case Quantity::HeaterPower: return reading.heaterPower;
    case Quantity::FanFrequency: return reading.fanFrequency;
    case Quantity::DisplacementX:
    case Quantity::DisplacementY:
        if (!reading.displacement || !reading.displacement->sum) {
            return {};
        }
        return quantity == Quantity::DisplacementX ? reading.displacement->sum->x : reading.displacement->sum->y;
    case Quantity::WindSpeed:
    case Quantity::WindDirection:
    case Quantity::WindMaximum:
    case Quantity::Pressure:
    case Quantity::Humidity: return reading.weather ? weatherOf(*reading.weather, quantity) : std::nullopt;
    default:
        if (!reading.acceleration || !isAccelerationValid(reading.status)) {
            return {};
        }
        return accelerationOf(*reading.acceleration, quantity);
    }
}

QList<Quantity> quantitiesOf(const SensorConfig &sensor)
{
    QList<Quantity> quantities;
    if (sensor.measuresTilt) {
        quantities << Quantity::TiltX << Quantity::TiltY;
    }
    if (sensor.measuresTemperature) {
        quantities << Quantity::Temperature;
    }
    if (sensor.hasThermostat) {
        quantities << Quantity::HeaterPower << Quantity::FanFrequency;
    }
    if (sensor.measuresAcceleration) {
        quantities << Quantity::AccelMaximum << Quantity::AccelMaximumX << Quantity::AccelMaximumY << Quantity::AccelRms
                   << Quantity::AccelRmsX << Quantity::AccelRmsY << Quantity::AccelDirection << Quantity::SampleX
                   << Quantity::SampleY;
    }
    if (sensor.isInChain) {
        quantities << Quantity::DisplacementX << Quantity::DisplacementY;
    }
    if (sensor.measuresWeather) {
        quantities << Quantity::WindSpeed << Quantity::WindDirection << Quantity::WindMaximum << Quantity::Pressure
                   << Quantity::Humidity;
    }
    return quantities;
}

} // namespace gorizont
