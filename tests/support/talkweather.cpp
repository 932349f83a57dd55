#include "tests/support/talkweather.h"

#include <array>

namespace gorizont::test {

QString spelledNumber(const std::optional<double> &value, const QString &expected)
{
    if (!value) {
        return QStringLiteral("none");
    }
    const qsizetype point = expected.indexOf(u'.');
    const int decimals = point < 0 ? 0 : static_cast<int>(expected.size() - point - 1);
    return QString::number(*value, 'f', decimals);
}

namespace {

struct WeatherField
{
    QLatin1String name;
    std::optional<double> WeatherParameter::*member;
};

constexpr std::array<WeatherField, 8> weatherFields{{
    {QLatin1String("mean"), &WeatherParameter::mean},
    {QLatin1String("instant"), &WeatherParameter::instant},
    {QLatin1String("min"), &WeatherParameter::minimum},
    {QLatin1String("max"), &WeatherParameter::maximum},
    {QLatin1String("voltage"), &WeatherParameter::voltage},
    {QLatin1String("voltageInstant"), &WeatherParameter::voltageInstant},
    {QLatin1String("maxPeriod"), &WeatherParameter::maxPeriod},
    {QLatin1String("deviation"), &WeatherParameter::deviation},
}};

/// `T1.mean`
QString spelled(const Weather &weather, const QString &key, const QString &expected)
{
    const QString field = key.section(u'.', 1);
    for (const WeatherField &known : weatherFields) {
        const WeatherParameter *parameter = weather.find(key.front(), key.section(u'.', 0, 0).mid(1).toInt());
        if (field == known.name) {
            return parameter ? spelledNumber(parameter->*known.member, expected) : QStringLiteral("no such parameter");
        }
    }
    return QStringLiteral("?");
}

QString spelled(const QList<PrecipitationEvent> &events)
{
    QStringList times;
    for (const PrecipitationEvent &event : events) {
        times.append(QString::number(event.isStart ? event.time : -event.time));
    }
    return times.isEmpty() ? QStringLiteral("none") : times.join(u' ');
}

} // namespace

QString spelledWeather(const std::optional<Weather> &weather, const QString &key, const QString &expected)
{
    if (!weather) {
        return QStringLiteral("none");
    }
    if (key == QLatin1String("parameters")) {
        return QString::number(weather->parameters.size());
    }
    if (key == QLatin1String("digital")) {
        return QStringLiteral("0x%1").arg(weather->digital, 8, 16, QLatin1Char('0'));
    }
    return key == QLatin1String("events") ? spelled(weather->events) : spelled(*weather, key, expected);
}

} // namespace gorizont::test
