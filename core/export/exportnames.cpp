#include "core/export/exportnames.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace gorizont::exportname {

namespace {

/// The translation context of every name.
struct Export
{
    Q_DECLARE_TR_FUNCTIONS(Export)
};

struct Name
{
    Quantity quantity;
    const char *key;
    const char *unitKey;
    int decimals;
};

constexpr std::array names{
    Name{Quantity::TiltX, "tilt-x", "arcsec", 3},
    Name{Quantity::TiltY, "tilt-y", "arcsec", 3},
    Name{Quantity::Temperature, "temperature", "degC", 3},
    Name{Quantity::HeaterPower, "heater", "%", 2},
    Name{Quantity::FanFrequency, "fan", "1/s", 3},
    Name{Quantity::AccelMaximum, "accel-max", "mm/s2", 4},
    Name{Quantity::AccelMaximumX, "accel-max-x", "mm/s2", 4},
    Name{Quantity::AccelMaximumY, "accel-max-y", "mm/s2", 4},
    Name{Quantity::AccelRms, "accel-rms", "mm/s2", 4},
    Name{Quantity::AccelRmsX, "accel-rms-x", "mm/s2", 4},
    Name{Quantity::AccelRmsY, "accel-rms-y", "mm/s2", 4},
    Name{Quantity::AccelDirection, "accel-direction", "deg", 2},
    Name{Quantity::SampleX, "sample-x", "mm/s2", 4},
    Name{Quantity::SampleY, "sample-y", "mm/s2", 4},
    Name{Quantity::DisplacementX, "displacement-x", "mm", 3},
    Name{Quantity::DisplacementY, "displacement-y", "mm", 3},
    Name{Quantity::WindSpeed, "wind-speed", "m/s", 2},
    Name{Quantity::WindDirection, "wind-direction", "deg", 1},
    Name{Quantity::WindMaximum, "wind-max", "m/s", 2},
    Name{Quantity::Pressure, "pressure", "mmHg", 2},
    Name{Quantity::Humidity, "humidity", "%", 2},
};

const Name &nameOf(Quantity quantity)
{
    return *std::find_if(names.begin(), names.end(), [quantity](const Name &name) {
        return name.quantity == quantity;
    });
}

} // namespace

QString key(Quantity quantity)
{
    return QString::fromLatin1(nameOf(quantity).key);
}

std::optional<Quantity> quantityOfKey(const QString &key)
{
    for (const Name &name : names) {
        if (key == QLatin1String(name.key)) {
            return name.quantity;
        }
    }
    return {};
}

QString unitKey(Quantity quantity)
{
    return QString::fromLatin1(nameOf(quantity).unitKey);
}

int decimals(Quantity quantity)
{
    return nameOf(quantity).decimals;
}

QString quantity(Quantity quantity)
{
    switch (quantity) {
    case Quantity::TiltX: return Export::tr("Tilt X");
    case Quantity::TiltY: return Export::tr("Tilt Y");
    case Quantity::Temperature: return Export::tr("Temperature");
    case Quantity::HeaterPower: return Export::tr("Heater power");
    case Quantity::FanFrequency: return Export::tr("Fan frequency");
    case Quantity::AccelMaximum: return Export::tr("Maximum acceleration");
    case Quantity::AccelMaximumX: return Export::tr("Maximum acceleration, X");
    case Quantity::AccelMaximumY: return Export::tr("Maximum acceleration, Y");
    case Quantity::AccelRms: return Export::tr("RMS acceleration");
    case Quantity::AccelRmsX: return Export::tr("RMS acceleration, X");
    case Quantity::AccelRmsY: return Export::tr("RMS acceleration, Y");
    case Quantity::AccelDirection: return Export::tr("Direction of the maximum");
    case Quantity::SampleX: return Export::tr("Acceleration X");
    case Quantity::SampleY: return Export::tr("Acceleration Y");
    case Quantity::DisplacementX: return Export::tr("Displacement X");
    case Quantity::DisplacementY: return Export::tr("Displacement Y");
    case Quantity::WindSpeed: return Export::tr("Wind speed");
    case Quantity::WindDirection: return Export::tr("Wind direction");
    case Quantity::WindMaximum: return Export::tr("Maximum wind speed");
    case Quantity::Pressure: return Export::tr("Pressure");
    case Quantity::Humidity: return Export::tr("Humidity");
    }
    return {};
}

QString unit(Quantity quantity)
{
    switch (quantity) {
    case Quantity::TiltX:
    case Quantity::TiltY: return Export::tr("arc-seconds");
    case Quantity::Temperature: return Export::tr("°C");
    case Quantity::HeaterPower:
    case Quantity::Humidity: return Export::tr("%");
    case Quantity::FanFrequency: return Export::tr("1/s");
    case Quantity::AccelDirection:
    case Quantity::WindDirection: return Export::tr("degrees");
    case Quantity::WindSpeed:
    case Quantity::WindMaximum: return Export::tr("m/s");
    case Quantity::Pressure: return Export::tr("mm Hg");
    case Quantity::DisplacementX:
    case Quantity::DisplacementY: return Export::tr("mm");
    default: return Export::tr("mm/s²");
    }
}

} // namespace gorizont::exportname
