#include "ui/plots/plottext.h"

#include "core/values/sensorconfig.h"
#include "core/values/sensortype.h"
#include "ui/models/valuetext.h"

#include <QCoreApplication>
#include <QDateTime>

namespace gorizont::plottext {

namespace {

/// The translation context of everything that plots say of quantities.
struct PlotText
{
    Q_DECLARE_TR_FUNCTIONS(PlotText)
};

int decimals(ValueAxis axis, TiltUnit unit)
{
    switch (axis) {
    case ValueAxis::Tilt: return unit == TiltUnit::Degrees ? 4 : 1;
    case ValueAxis::Temperature:
    case ValueAxis::Displacement:
    case ValueAxis::Wind:
    case ValueAxis::Acceleration: return 2;
    case ValueAxis::Pressure:
    case ValueAxis::Humidity:
    case ValueAxis::Power:
    case ValueAxis::Frequency:
    case ValueAxis::Direction: break;
    }
    return 1;
}

QString axisName(ValueAxis axis)
{
    switch (axis) {
    case ValueAxis::Tilt: return PlotText::tr("Tilt");
    case ValueAxis::Temperature: return PlotText::tr("Temperature");
    case ValueAxis::Power: return PlotText::tr("Heater power");
    case ValueAxis::Frequency: return PlotText::tr("Fan");
    case ValueAxis::Acceleration: return PlotText::tr("Acceleration");
    case ValueAxis::Direction: return PlotText::tr("Direction");
    case ValueAxis::Displacement: return PlotText::tr("Displacement");
    case ValueAxis::Wind: return PlotText::tr("Wind");
    case ValueAxis::Pressure: return PlotText::tr("Pressure");
    case ValueAxis::Humidity: return PlotText::tr("Humidity");
    }
    return {};
}

} // namespace

ValueAxis axisOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::TiltX:
    case Quantity::TiltY: return ValueAxis::Tilt;
    case Quantity::Temperature: return ValueAxis::Temperature;
    case Quantity::HeaterPower: return ValueAxis::Power;
    case Quantity::FanFrequency: return ValueAxis::Frequency;
    case Quantity::AccelDirection:
    case Quantity::WindDirection: return ValueAxis::Direction;
    case Quantity::WindSpeed:
    case Quantity::WindMaximum: return ValueAxis::Wind;
    case Quantity::Pressure: return ValueAxis::Pressure;
    case Quantity::Humidity: return ValueAxis::Humidity;
    case Quantity::DisplacementX:
    case Quantity::DisplacementY: return ValueAxis::Displacement;
    default: return ValueAxis::Acceleration;
    }
}

double scaleOf(Quantity quantity, TiltUnit unit)
{
    constexpr double arcSecondsOfDegree = 3600;
    return axisOf(quantity) == ValueAxis::Tilt && unit == TiltUnit::Degrees ? 1 / arcSecondsOfDegree : 1;
}

QString unitOf(ValueAxis axis, TiltUnit unit)
{
    switch (axis) {
    case ValueAxis::Tilt: return unit == TiltUnit::Degrees ? QStringLiteral("°") : QStringLiteral("″");
    case ValueAxis::Temperature: return QStringLiteral("°C");
    case ValueAxis::Power: return QStringLiteral("%");
    case ValueAxis::Frequency: return PlotText::tr("rev/s");
    case ValueAxis::Acceleration: return PlotText::tr("mm/s²");
    case ValueAxis::Direction: return QStringLiteral("°");
    case ValueAxis::Displacement: return PlotText::tr("mm");
    case ValueAxis::Wind: return PlotText::tr("m/s");
    case ValueAxis::Pressure: return PlotText::tr("mm Hg");
    case ValueAxis::Humidity: return QStringLiteral("%");
    }
    return {};
}

QString axisTitle(ValueAxis axis, TiltUnit unit)
{
    return QStringLiteral("%1, %2").arg(axisName(axis), unitOf(axis, unit));
}

QString quantity(Quantity quantity)
{
    switch (quantity) {
    case Quantity::TiltX: return QStringLiteral("Mx");
    case Quantity::TiltY: return QStringLiteral("My");
    case Quantity::Temperature: return PlotText::tr("T");
    case Quantity::HeaterPower: return PlotText::tr("P of the heater");
    case Quantity::FanFrequency: return PlotText::tr("Frequency of the fan");
    case Quantity::AccelMaximum: return QStringLiteral("Amax");
    case Quantity::AccelMaximumX: return QStringLiteral("Amax X");
    case Quantity::AccelMaximumY: return QStringLiteral("Amax Y");
    case Quantity::AccelRms: return QStringLiteral("Arms");
    case Quantity::AccelRmsX: return QStringLiteral("Arms X");
    case Quantity::AccelRmsY: return QStringLiteral("Arms Y");
    case Quantity::AccelDirection: return PlotText::tr("Direction of Amax");
    case Quantity::SampleX: return QStringLiteral("Ax");
    case Quantity::SampleY: return QStringLiteral("Ay");
    case Quantity::DisplacementX: return PlotText::tr("Displacement X");
    case Quantity::DisplacementY: return PlotText::tr("Displacement Y");
    case Quantity::WindSpeed: return PlotText::tr("Wind speed");
    case Quantity::WindDirection: return PlotText::tr("Wind direction");
    case Quantity::WindMaximum: return PlotText::tr("Maximum wind speed");
    case Quantity::Pressure: return PlotText::tr("Pressure");
    case Quantity::Humidity: return PlotText::tr("Humidity");
    }
    return {};
}

QString curve(const SensorConfig &sensor, Quantity quantity)
{
    QStringList parts{QString::number(sensor.number)};
    parts += sensor.model.isEmpty() ? sensor.name : modelInRussian(sensor.model);
    if (!sensor.place.isEmpty()) {
        parts += u'[' + sensor.place + u']';
    }
    parts += plottext::quantity(quantity);
    return parts.join(u' ');
}

QString value(std::optional<double> drawn, ValueAxis axis, TiltUnit unit)
{
    return valuetext::fixed(drawn, decimals(axis, unit));
}

QString signedValue(std::optional<double> drawn, ValueAxis axis, TiltUnit unit)
{
    return valuetext::signedFixed(drawn, decimals(axis, unit));
}

QString moment(UtcTime time)
{
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    return QDateTime::fromMSecsSinceEpoch(milliseconds).toString(QStringLiteral("dd.MM.yyyy hh:mm:ss"));
}

QString duration(std::chrono::microseconds time)
{
    const auto seconds = std::chrono::round<std::chrono::seconds>(time).count();
    const QString clock = QString::asprintf(
        "%02d:%02d:%02d", static_cast<int>(seconds / 3600 % 24), static_cast<int>(seconds / 60 % 60),
        static_cast<int>(seconds % 60));
    const auto days = seconds / 86400;
    return days > 0 ? PlotText::tr("%1 d %2").arg(QString::number(days), clock) : clock;
}

} // namespace gorizont::plottext
