#include "core/values/weatherjson.h"

#include <QJsonArray>

namespace gorizont {

namespace {

QJsonObject objectOf(const WeatherParameter &parameter)
{
    QJsonObject object{
        {QStringLiteral("code"), QString(parameter.code)},
        {QStringLiteral("number"), parameter.number},
        {QStringLiteral("name"), parameter.name},
        {QStringLiteral("unit"), parameter.unit},
    };
    const auto insert = [&object](const QString &key, const std::optional<double> &value) {
        if (value) {
            object.insert(key, *value);
        }
    };
    insert(QStringLiteral("mean"), parameter.mean);
    insert(QStringLiteral("instant"), parameter.instant);
    insert(QStringLiteral("min"), parameter.minimum);
    insert(QStringLiteral("max"), parameter.maximum);
    insert(QStringLiteral("voltage"), parameter.voltage);
    insert(QStringLiteral("voltageInstant"), parameter.voltageInstant);
    insert(QStringLiteral("maxPeriod"), parameter.maxPeriod);
    insert(QStringLiteral("deviation"), parameter.deviation);
    return object;
}

} // namespace

void insertWeather(QJsonObject &object, const Weather &weather)
{
    QJsonArray parameters;
    for (const WeatherParameter &parameter : weather.parameters) {
        parameters.append(objectOf(parameter));
    }
    QJsonArray events;
    for (const PrecipitationEvent &event : weather.events) {
        events.append(QJsonObject{{QStringLiteral("start"), event.isStart}, {QStringLiteral("time"), event.time}});
    }
    object.insert(QStringLiteral("digital"), static_cast<qint64>(weather.digital));
    object.insert(QStringLiteral("parameters"), parameters);
    object.insert(QStringLiteral("events"), events);
}

} // namespace gorizont
