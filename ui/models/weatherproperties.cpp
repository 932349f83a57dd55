#include "ui/models/weatherproperties.h"

#include "ui/models/valuetext.h"
#include "ui/models/weathertext.h"
#include "ui/models/windrose.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

/// The translation context of the rows.
struct WeatherRows
{
    Q_DECLARE_TR_FUNCTIONS(WeatherRows)
};

using Values = std::optional<double> WeatherParameter::*;

/// `-4.25 (-4.20 | -5.00 … -3.90)`; what the command does not give is left out, unless nothing is left.
QString values(const WeatherParameter &parameter)
{
    QString more = parameter.instant ? weathertext::value(parameter, parameter.instant) : QString();
    if (parameter.minimum || parameter.maximum) {
        more += (more.isEmpty() ? QString() : QStringLiteral(" | "))
            + QStringLiteral("%1 … %2").arg(
                weathertext::value(parameter, parameter.minimum), weathertext::value(parameter, parameter.maximum));
    }
    const QString mean = weathertext::value(parameter, parameter.mean);
    return more.isEmpty() ? mean : QStringLiteral("%1 (%2)").arg(mean, more);
}

QString rowName(const WeatherParameter &parameter)
{
    QString title = parameter.name;
    title += (title.isEmpty() ? QString() : QStringLiteral(" ")) + weathertext::code(parameter);
    return parameter.unit.isEmpty() ? title : QStringLiteral("%1, %2").arg(title, parameter.unit);
}

Property speedRow(const QString &name, const Weather *weather, Values member, const QString &note)
{
    const WeatherParameter *speed = weather ? weather->find(weathercode::windSpeed) : nullptr;
    return {name, speed ? weathertext::value(*speed, speed->*member) : valuetext::absent(), note};
}

Property directionRow(const QString &name, const Weather *weather, Values member, const QString &note)
{
    const WeatherParameter *direction = weather ? weather->find(weathercode::windDirection) : nullptr;
    return {name, weathertext::direction(direction ? direction->*member : std::nullopt), note};
}

QString deviationOf(const Weather *weather, QChar code)
{
    const WeatherParameter *parameter = weather ? weather->find(code) : nullptr;
    return parameter ? weathertext::deviation(*parameter) : valuetext::absent();
}

QString percent(const WindCounts &counts, quint32 count)
{
    return counts.total() == 0 ? valuetext::absent() : valuetext::fixed(100 * counts.share(count), 1);
}

Properties gatheredProperties(const WindCounts &counts)
{
    const auto prevailing = counts.prevailing();
    const bool isEmpty = counts.total() == 0;
    return {
        Property::section(WeatherRows::tr("Gathered since the program started, over the chosen time")),
        {WeatherRows::tr("Readings"), QString::number(counts.total()),
         WeatherRows::tr("how many readings of the wind the rose consists of")},
        {WeatherRows::tr("Prevailing direction"),
         prevailing ? QStringLiteral("%1 (%2 %)")
                          .arg(weathertext::rumb(*prevailing), percent(counts, counts.inSector(*prevailing)))
                    : valuetext::absent(),
         WeatherRows::tr("the rumb from which the wind blew most often, and its share of all readings")},
        {WeatherRows::tr("Mean speed, m/s"), valuetext::fixed(counts.meanSpeed(), 1),
         WeatherRows::tr("mean of the mean speeds")},
        {WeatherRows::tr("Strongest gust, m/s"),
         valuetext::fixed(isEmpty ? std::nullopt : std::optional(counts.fastest), 1),
         WeatherRows::tr("the largest speed that the station reported")},
        {WeatherRows::tr("Calm, %"), percent(counts, counts.calm),
         WeatherRows::tr("share of the readings below %1 m/s").arg(windrose::calm, 0, 'f', 1)},
        {WeatherRows::tr("Without direction, %"), percent(counts, counts.undirected),
         WeatherRows::tr("share of the readings whose speed is valid and whose direction is not")},
    };
}

} // namespace

Properties weatherProperties(const SensorRegistry::Sensor &sensor, LineState line)
{
    if (!sensor.reading.weather) {
        return {};
    }
    const Weather *shown = shownWeather(sensor, line);
    Properties rows;
    for (const WeatherParameter &parameter : sensor.reading.weather->parameters) {
        rows += Property{
            rowName(parameter), shown ? values(parameter) : valuetext::absent(),
            WeatherRows::tr("mean value (instantaneous value | minimum … maximum), as far as the station gives them")};
    }
    rows += Property{
        WeatherRows::tr("Digital inputs"), shown ? weathertext::digital(shown->digital) : valuetext::absent(),
        WeatherRows::tr("the word of the inputs, and the numbers of those that are on; the first one is 0")};
    return rows;
}

Properties windProperties(const Weather *weather, const WindCounts &counts)
{
    const auto components = weather ? WindComponents::of(*weather) : std::nullopt;
    Properties rows{
        directionRow(
            WeatherRows::tr("Direction"), weather, &WeatherParameter::mean,
            WeatherRows::tr("from where it blows, mean: degrees from the north clockwise, and the rumb")),
        directionRow(
            WeatherRows::tr("Direction now"), weather, &WeatherParameter::instant,
            WeatherRows::tr("from where it blows at this moment")),
        speedRow(
            WeatherRows::tr("Speed, m/s"), weather, &WeatherParameter::mean,
            WeatherRows::tr("mean of the modulus over the averaging interval of the station")),
        speedRow(
            WeatherRows::tr("Speed now, m/s"), weather, &WeatherParameter::instant,
            WeatherRows::tr("speed of the last seconds")),
        speedRow(
            WeatherRows::tr("Gust, m/s"), weather, &WeatherParameter::maximum,
            WeatherRows::tr("maximum over the averaging interval of the station")),
        speedRow(
            WeatherRows::tr("Gust since the last request, m/s"), weather, &WeatherParameter::maxPeriod,
            WeatherRows::tr("maximum since the station was asked before")),
        {WeatherRows::tr("σ of the direction, °"), deviationOf(weather, weathercode::windDirection),
         WeatherRows::tr("root mean square deviation of the direction")},
        {WeatherRows::tr("σ of the speed, m/s"), deviationOf(weather, weathercode::windSpeed),
         WeatherRows::tr("root mean square deviation of the speed")},
        {WeatherRows::tr("U, V, m/s"), weathertext::components(components),
         WeatherRows::tr("components of the mean wind: U > 0 blows towards the east, V > 0 towards the north")},
    };
    return rows + gatheredProperties(counts);
}

QString windComponents(const SensorRegistry::Sensor &sensor, LineState line)
{
    const Weather *weather = shownWeather(sensor, line);
    return weathertext::components(weather ? WindComponents::of(*weather) : std::nullopt);
}

QString weatherSummary(const SensorRegistry::Sensor &sensor, LineState line)
{
    const Weather *weather = shownWeather(sensor, line);
    return weather ? weathertext::summary(*weather) : QString();
}

} // namespace gorizont
