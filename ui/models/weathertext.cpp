#include "ui/models/weathertext.h"

#include "core/values/wind.h"
#include "ui/models/health.h"
#include "ui/models/valuetext.h"
#include "ui/models/windrose.h"

#include <QCoreApplication>
#include <QHash>

#include <array>
#include <cmath>
#include <numbers>

namespace gorizont {

namespace {

/// The translation context of the weather.
struct WeatherText
{
    Q_DECLARE_TR_FUNCTIONS(WeatherText)
};

/// Behind the point, as manual 004, section 4.2, gives them.
int decimals(QChar code)
{
    constexpr int others = 2;
    static const QHash<QChar, int> usual{{weathercode::supply, 1},        {weathercode::temperature, 2},
                                         {weathercode::pressure, 1},      {weathercode::humidity, 1},
                                         {weathercode::windDirection, 0}, {weathercode::windSpeed, 1},
                                         {weathercode::windVector, 1}};
    return usual.value(code, others);
}

} // namespace

const Weather *shownWeather(const SensorRegistry::Sensor &sensor, LineState line)
{
    const Reading &reading = sensor.reading;
    const Health health = sensorHealth(sensor, line);
    const bool isAnswering = health == Health::Good || health == Health::Warning
        || (health == Health::Error && statusCode(reading.status) >= StatusCode::TransducerSilent);
    return isAnswering && reading.weather ? &*reading.weather : nullptr;
}

std::optional<WindComponents> WindComponents::of(const Weather &weather)
{
    const auto direction = meanOf(weather, weathercode::windDirection);
    const auto vector = meanOf(weather, weathercode::windVector);
    const auto speed = vector ? vector : meanOf(weather, weathercode::windSpeed);
    if (!direction || !speed) {
        return {};
    }
    const double angle = *direction * std::numbers::pi / 180;
    return WindComponents{-*speed * std::sin(angle), -*speed * std::cos(angle)};
}

namespace weathertext {

QString rumb(int sector)
{
    static constexpr std::array names{QT_TRANSLATE_NOOP("WeatherText", "N"),  QT_TRANSLATE_NOOP("WeatherText", "NNE"),
                                      QT_TRANSLATE_NOOP("WeatherText", "NE"), QT_TRANSLATE_NOOP("WeatherText", "ENE"),
                                      QT_TRANSLATE_NOOP("WeatherText", "E"),  QT_TRANSLATE_NOOP("WeatherText", "ESE"),
                                      QT_TRANSLATE_NOOP("WeatherText", "SE"), QT_TRANSLATE_NOOP("WeatherText", "SSE"),
                                      QT_TRANSLATE_NOOP("WeatherText", "S"),  QT_TRANSLATE_NOOP("WeatherText", "SSW"),
                                      QT_TRANSLATE_NOOP("WeatherText", "SW"), QT_TRANSLATE_NOOP("WeatherText", "WSW"),
                                      QT_TRANSLATE_NOOP("WeatherText", "W"),  QT_TRANSLATE_NOOP("WeatherText", "WNW"),
                                      QT_TRANSLATE_NOOP("WeatherText", "NW"), QT_TRANSLATE_NOOP("WeatherText", "NNW")};
    return WeatherText::tr(names.at(static_cast<std::size_t>(sector)));
}

QString rumbOf(double degrees)
{
    return rumb(windrose::sectorOf(degrees));
}

/// 359.7° is written as 0°: a compass has no 360.
QString direction(std::optional<double> degrees)
{
    if (!degrees) {
        return valuetext::absent();
    }
    return QStringLiteral("%1° %2").arg(std::lround(windrose::normalized(*degrees)) % 360).arg(rumbOf(*degrees));
}

QString components(const std::optional<WindComponents> &wind)
{
    const auto tenths = [](double speed) { return std::round(10 * speed) / 10 + 0.0; }; // −0.04 is +0.0
    return wind ? valuetext::signedFixed(tenths(wind->u), 1) + u' ' + valuetext::signedFixed(tenths(wind->v), 1)
                : valuetext::absent();
}

QString code(const WeatherParameter &parameter)
{
    return parameter.code + QString::number(parameter.number);
}

QString value(const WeatherParameter &parameter, std::optional<double> value)
{
    return valuetext::fixed(value, decimals(parameter.code));
}

QString deviation(const WeatherParameter &parameter)
{
    return valuetext::fixed(parameter.deviation, decimals(parameter.code) + 1);
}

QString voltage(std::optional<double> value)
{
    return valuetext::fixed(value, 3);
}

QString digital(quint32 word)
{
    constexpr int inputs = 32;
    QStringList on;
    for (int input = 0; input < inputs; ++input) {
        if (word >> input & 1U) {
            on += QString::number(input);
        }
    }
    const QString hexadecimal = QStringLiteral("0x%1").arg(word, 8, 16, QLatin1Char('0')).toUpper().replace(u'X', u'x');
    return QStringLiteral("%1 (%2)").arg(
        hexadecimal, on.isEmpty() ? WeatherText::tr("none is on") : on.join(QStringLiteral(", ")));
}

QString summary(const Weather &weather)
{
    QStringList parts;
    const WeatherParameter *speed = weather.find(weathercode::windSpeed);
    if (speed && speed->mean) {
        const auto from = meanOf(weather, weathercode::windDirection);
        const QString text = WeatherText::tr("wind %1 %2").arg(value(*speed, speed->mean), speed->unit);
        parts += from ? text + QStringLiteral(", ") + direction(from) : text;
    }
    const WeatherParameter *temperature = weather.find(weathercode::temperature);
    if (temperature && temperature->mean) {
        parts += WeatherText::tr("temperature %1 %2").arg(value(*temperature, temperature->mean), temperature->unit);
    }
    return parts.join(QStringLiteral("; "));
}

} // namespace weathertext

} // namespace gorizont
