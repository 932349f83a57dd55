#include "core/modbus/tiltmap.h"

#include <QtGlobal>

namespace gorizont {

namespace {

constexpr double degreesPerArcSecond = 1.0 / 3600.0;

constexpr std::array<HeadField, 1> head{{
    {0, RegisterType::UInt32, 1, "channels", "", QT_TRANSLATE_NOOP("RegisterMap", "Channel word: two bits a port"),
     [](const HeadState &s) { return std::optional<double>(s.channels); }},
}};

constexpr std::array<SlotField, 4> sensor{{
    {0, RegisterType::Int16, 1000, "tilt_x", "°", QT_TRANSLATE_NOOP("RegisterMap", "Tilt along X"),
     [](const SlotState &s) {
         return s.reading.tilt ? std::optional(s.reading.tilt->x * degreesPerArcSecond) : std::nullopt;
     }},
    {1, RegisterType::Int16, 1000, "tilt_y", "°", QT_TRANSLATE_NOOP("RegisterMap", "Tilt along Y"),
     [](const SlotState &s) {
         return s.reading.tilt ? std::optional(s.reading.tilt->y * degreesPerArcSecond) : std::nullopt;
     }},
    {2, RegisterType::Int16, 100, "temperature", "°C", QT_TRANSLATE_NOOP("RegisterMap", "Temperature"),
     [](const SlotState &s) { return s.reading.temperature; }},
    {3, RegisterType::UInt16, 1, "status", "", QT_TRANSLATE_NOOP("RegisterMap", "Status word of the sensor"),
     [](const SlotState &s) { return std::optional<double>(s.reading.status); }},
}};

constexpr int headSize = 2;
constexpr int stride = 4;
static_assert(areApart(head, headSize) && areApart(sensor, stride));

constexpr std::array<SlotPart, 1> parts{{{"", "", headSize, stride, sensor}}};

} // namespace

const UnitLayout &tiltMap()
{
    static const UnitLayout layout{
        3,
        QT_TRANSLATE_NOOP("RegisterMap", "Angles of tilt"),
        QT_TRANSLATE_NOOP(
            "RegisterMap", "What is not valid keeps its last value, 0 if it never had one; the status word says so."),
        RegisterOrder::LowByteFirst,
        false,
        true,
        &SensorConfig::measuresTilt,
        head,
        parts,
    };
    return layout;
}

} // namespace gorizont
