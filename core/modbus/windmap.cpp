#include "core/modbus/windmap.h"

#include "core/modbus/registervalue.h"
#include "core/values/wind.h"

#include <QtGlobal>

#include <limits>

namespace gorizont {

namespace {

using Value = std::optional<double>;

constexpr double hundredths = 100;
constexpr double tenths = 10;

/// Saturates to FFFFh.
constexpr double noValue = std::numeric_limits<double>::infinity();

template <std::optional<double> Wind::*member> Value wind(const SlotState &s)
{
    return s.reading.weather ? (windOf(*s.reading.weather).*member).value_or(noValue) : Value();
}

/// 359.96° rounds to 360.0°, which is 0.
Value direction(const SlotState &s)
{
    const Value degrees = wind<&Wind::direction>(s);
    return degrees && wordRegister(*degrees, tenths) == 3600 ? 0 : degrees;
}

constexpr std::array<HeadField, 1> head{{
    {0, RegisterType::UInt32, 1, "channels", "", QT_TRANSLATE_NOOP("RegisterMap", "Channel word: two bits a port"),
     [](const HeadState &s) { return Value(s.channels); }},
}};

constexpr std::array<SlotField, 7> station{{
    {0, RegisterType::UInt16, hundredths, "wind_speed", QT_TRANSLATE_NOOP("RegisterMap", "m/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Speed of the wind, mean"), wind<&Wind::speed>},
    {1, RegisterType::UInt16, tenths, "wind_direction", "°",
     QT_TRANSLATE_NOOP("RegisterMap", "Direction of the wind, mean"), direction},
    {2, RegisterType::UInt16, hundredths, "wind_max", QT_TRANSLATE_NOOP("RegisterMap", "m/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Largest speed of the wind in the last turns"), wind<&Wind::maximum>},
    {3, RegisterType::UInt16, tenths, "wind_max_direction", "°",
     QT_TRANSLATE_NOOP("RegisterMap", "Direction of the largest speed; 0: stations do not say it"),
     [](const SlotState &) { return Value(0); }},
    {4, RegisterType::UInt16, hundredths, "wind_deviation", QT_TRANSLATE_NOOP("RegisterMap", "m/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Standard deviation of the speed of the wind"), wind<&Wind::deviation>},
    {5, RegisterType::UInt16, hundredths, "wind_direction_deviation", "°",
     QT_TRANSLATE_NOOP("RegisterMap", "Standard deviation of the direction of the wind"),
     wind<&Wind::directionDeviation>},
    {6, RegisterType::UInt16, 1, "status", "", QT_TRANSLATE_NOOP("RegisterMap", "Status word of the sensor"),
     [](const SlotState &s) { return Value(s.reading.status); }},
}};

constexpr int headSize = 2;
constexpr int stride = 7;
static_assert(areApart(head, headSize) && areApart(station, stride));

constexpr std::array<SlotPart, 1> parts{{{"", "", headSize, stride, station}}};

} // namespace

const UnitLayout &windMap()
{
    static const UnitLayout layout{
        4,
        QT_TRANSLATE_NOOP("RegisterMap", "Wind"),
        QT_TRANSLATE_NOOP(
            "RegisterMap",
            "A station that does not answer keeps its last values, 0 if there never were any; the status word says so. "
            "FFFFh: the station answers, but has no such value."),
        RegisterOrder::LowByteFirst,
        false,
        true,
        &SensorConfig::measuresWeather,
        head,
        parts,
    };
    return layout;
}

} // namespace gorizont
