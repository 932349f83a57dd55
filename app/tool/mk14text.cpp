#include "app/tool/mk14text.h"

#include "app/tool/output.h"
#include "app/tool/text.h"

#include <QDateTime>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

constexpr int decimals = 2;
constexpr int voltageDecimals = 4;

QString lineOf(const WeatherParameter &parameter)
{
    QStringList parts;
    const auto add = [&parts](const QString &what, const std::optional<double> &value, int places = decimals) {
        if (value) {
            parts.append(u"%1 %2"_s.arg(what, fixed(*value, places)));
        }
    };
    add(Text::tr("mean"), parameter.mean);
    add(Text::tr("now"), parameter.instant);
    add(Text::tr("min"), parameter.minimum);
    add(Text::tr("max"), parameter.maximum);
    add(Text::tr("max of the period"), parameter.maxPeriod);
    add(u"σ"_s, parameter.deviation);
    add(Text::tr("voltage"), parameter.voltage, voltageDecimals);
    add(Text::tr("voltage now"), parameter.voltageInstant, voltageDecimals);
    QString name = u"%1%2"_s.arg(parameter.code).arg(parameter.number);
    name += parameter.name.isEmpty() ? QString() : u' ' + parameter.name;
    name += parameter.unit.isEmpty() ? QString() : u", "_s + parameter.unit;
    return u"%1: %2"_s.arg(name, parts.isEmpty() ? none : parts.join(u"; "_s));
}

/// As the clock of the station shows it.
QString lineOf(const PrecipitationEvent &event)
{
    const QString time = QDateTime::fromSecsSinceEpoch(event.time, Qt::UTC).toString(u"yyyy-MM-dd hh:mm:ss"_s);
    return (event.isStart ? Text::tr("precipitation began %1") : Text::tr("precipitation ended %1")).arg(time);
}

} // namespace

QString textOf(const Weather &weather)
{
    QStringList lines;
    for (const WeatherParameter &parameter : weather.parameters) {
        lines.append(lineOf(parameter));
    }
    if (weather.parameters.isEmpty()) {
        lines.append(Text::tr("the station has no data"));
    }
    lines.append(Text::tr("digital inputs: %1").arg(weather.digital, 8, 16, QLatin1Char('0')));
    for (const PrecipitationEvent &event : weather.events) {
        lines.append(lineOf(event));
    }
    return lines.join(u'\n');
}

} // namespace gorizont::tool
