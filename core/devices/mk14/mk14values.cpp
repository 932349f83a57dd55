#include "core/devices/mk14/mk14values.h"

#include <algorithm>
#include <cmath>

namespace gorizont::mk14 {

namespace {

std::optional<double> number(const std::optional<float> &value)
{
    return value && std::isfinite(*value) ? std::optional<double>(*value) : std::nullopt;
}

WeatherParameter *firstOf(Weather &weather, QChar code)
{
    const auto found = std::find_if(weather.parameters.begin(), weather.parameters.end(), [code](const auto &p) {
        return p.code == code;
    });
    return found == weather.parameters.end() ? nullptr : &*found;
}

/// The three numbers and the times behind the means of CMD 8; those of the wind belong to its first two sensors.
void putExtras(Weather &weather, const ack::Answer &answer)
{
    if (WeatherParameter *direction = firstOf(weather, weathercode::windDirection)) {
        direction->deviation = number(answer.extras.value(0));
    }
    if (WeatherParameter *speed = firstOf(weather, weathercode::windSpeed)) {
        speed->deviation = number(answer.extras.value(1));
        speed->maxPeriod = number(answer.extras.value(2));
    }
    weather.events.clear();
    for (const qint32 time : answer.precipitation) {
        weather.events.append({time > 0, std::abs(qint64{time})});
    }
}

WeatherParameter named(qsizetype place, const QList<ParameterName> &names)
{
    WeatherParameter parameter;
    if (place < names.size()) {
        const ParameterName &name = names.at(place);
        parameter.code = name.code;
        parameter.number = name.number;
        parameter.name = name.name;
        parameter.unit = name.unit;
    } else {
        parameter.code = u'?';
        parameter.number = static_cast<int>(place) + 1;
    }
    return parameter;
}

} // namespace

void put(Weather &weather, int command, const ack::Answer &answer, const QList<ParameterName> &names)
{
    const auto members = ack::membersOf(command);
    weather.digital = answer.digital;
    weather.parameters.resize(std::min(weather.parameters.size(), answer.parameters.size()));
    for (qsizetype i = 0; i < answer.parameters.size(); ++i) {
        if (i == weather.parameters.size()) {
            weather.parameters.append(named(i, names));
        }
        for (qsizetype k = 0; k < members.size(); ++k) {
            weather.parameters[i].*members.at(k) = number(answer.parameters.at(i).value(k));
        }
    }
    if (command == ack::lastDataCommand) {
        putExtras(weather, answer);
    }
}

std::optional<double> temperatureIn(const Weather &weather)
{
    for (const WeatherParameter &parameter : weather.parameters) {
        if (parameter.code.toUpper() == weathercode::temperature) {
            return parameter.mean;
        }
    }
    return std::nullopt;
}

bool isSupplyBad(const Weather &weather)
{
    const WeatherParameter *supply = weather.find(weathercode::supply);
    return supply && !supply->mean && !supply->instant;
}

} // namespace gorizont::mk14
