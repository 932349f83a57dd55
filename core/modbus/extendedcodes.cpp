#include "core/modbus/extendedcodes.h"

#include <QtGlobal>

namespace gorizont {

bool hasTilt(const SlotState &s)
{
    return s.reading.tilt && isTiltValid(s.reading.status);
}
bool hasTemperature(const SlotState &s)
{
    return s.reading.temperature && isTemperatureValid(s.reading.status);
}
bool hasAcceleration(const SlotState &s)
{
    return s.reading.acceleration && isAccelerationValid(s.reading.status);
}

std::span<const SlotBit> extendedFlags()
{
    static constexpr std::array<SlotBit, 11> bits{{
        {0, QT_TRANSLATE_NOOP("RegisterMap", "the slot belongs to a sensor"),
         [](const SlotState &s) { return !s.slot.isHole(); }},
        {1, QT_TRANSLATE_NOOP("RegisterMap", "the sensor is switched on"),
         [](const SlotState &s) { return s.slot.sensor.isOn; }},
        {2, QT_TRANSLATE_NOOP("RegisterMap", "its port is switched on"),
         [](const SlotState &s) { return s.slot.isPortOn; }},
        {3, QT_TRANSLATE_NOOP("RegisterMap", "it answers"), [](const SlotState &s) { return s.isCurrent; }},
        {4, QT_TRANSLATE_NOOP("RegisterMap", "tilt is valid"), hasTilt},
        {5, QT_TRANSLATE_NOOP("RegisterMap", "temperature is valid"), hasTemperature},
        {6, QT_TRANSLATE_NOOP("RegisterMap", "accelerations are valid"), hasAcceleration},
        {7, QT_TRANSLATE_NOOP("RegisterMap", "raw_status holds a word"),
         [](const SlotState &s) { return s.reading.rawStatus.has_value(); }},
        {8, QT_TRANSLATE_NOOP("RegisterMap", "raw_mode holds a word"),
         [](const SlotState &s) { return s.reading.rawMode.has_value(); }},
        {9, QT_TRANSLATE_NOOP("RegisterMap", "packets of samples are counted"),
         [](const SlotState &s) { return s.reading.ring.has_value(); }},
        {11, QT_TRANSLATE_NOOP("RegisterMap", "channels_at says where its channels are"),
         [](const SlotState &s) { return s.areaAt != 0; }},
    }};
    return bits;
}

std::span<const SlotBit> extendedQuantities()
{
    static constexpr std::array<SlotBit, 5> bits{{
        {0, QT_TRANSLATE_NOOP("RegisterMap", "tilt"), [](const SlotState &s) { return s.slot.sensor.measuresTilt; }},
        {1, QT_TRANSLATE_NOOP("RegisterMap", "temperature"),
         [](const SlotState &s) { return s.slot.sensor.measuresTemperature; }},
        {2, QT_TRANSLATE_NOOP("RegisterMap", "acceleration"),
         [](const SlotState &s) { return s.slot.sensor.measuresAcceleration; }},
        {3, QT_TRANSLATE_NOOP("RegisterMap", "thermostat"),
         [](const SlotState &s) { return s.slot.sensor.hasThermostat; }},
        {5, QT_TRANSLATE_NOOP("RegisterMap", "vibration"),
         [](const SlotState &s) { return s.slot.sensor.type == SensorType::LVims; }},
    }};
    return bits;
}

std::span<const TypeCode> extendedTypes()
{
    static constexpr std::array<TypeCode, 6> types{{
        {SensorType::None, 0, QT_TRANSLATE_NOOP("RegisterMap", "no type, never polled")},
        {SensorType::InD, 1, QT_TRANSLATE_NOOP("RegisterMap", "IN-D2, IN-D3, IN-D7, IN-D9")},
        {SensorType::AnD3, 2, QT_TRANSLATE_NOOP("RegisterMap", "AN-D3")},
        {SensorType::UsmIsn, 3, QT_TRANSLATE_NOOP("RegisterMap", "USM-ISN")},
        {SensorType::LVims, 4, QT_TRANSLATE_NOOP("RegisterMap", "L-VIMS")},
        {SensorType::Mk14, 5, QT_TRANSLATE_NOOP("RegisterMap", "MK-14")},
    }};
    return types;
}

} // namespace gorizont
