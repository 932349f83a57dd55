#include "core/modbus/accelerationmap.h"

#include "core/modbus/registervalue.h"

namespace gorizont {

namespace {

using Value = std::optional<double>;

constexpr double tenths = 10; ///< of a degree

/// 359.96° rounds to 360.0°, which is 0: a direction stays below a full turn.
double belowFullTurn(double degrees)
{
    return shortRegister(degrees, tenths) == 3600 ? 0 : degrees;
}

constexpr std::array<HeadField, 1> head{{
    {0, RegisterType::UInt32, 1, "channels", "", QT_TRANSLATE_NOOP("RegisterMap", "Channel word: two bits a port"),
     [](const HeadState &s) { return Value(s.channels); }},
}};

constexpr std::array<SlotField, 5> sensor{{
    {0, RegisterType::Int16, 100, "accel_max", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "Largest acceleration, modulus"),
     [](const SlotState &s) { return s.reading.acceleration ? Value(s.reading.acceleration->maximum) : Value(); }},
    {1, RegisterType::Int16, tenths, "accel_direction", "°",
     QT_TRANSLATE_NOOP("RegisterMap", "Direction of the largest acceleration"),
     [](const SlotState &s) {
         return s.reading.acceleration ? Value(belowFullTurn(s.reading.acceleration->direction)) : Value();
     }},
    {2, RegisterType::UInt16, 100, "accel_rms_x", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "RMS of the acceleration along X"),
     [](const SlotState &s) { return s.reading.acceleration ? Value(s.reading.acceleration->rmsX) : Value(); }},
    {3, RegisterType::UInt16, 100, "accel_rms_y", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "RMS of the acceleration along Y"),
     [](const SlotState &s) { return s.reading.acceleration ? Value(s.reading.acceleration->rmsY) : Value(); }},
    {4, RegisterType::UInt16, 1, "status", "", QT_TRANSLATE_NOOP("RegisterMap", "Status word of the sensor"),
     [](const SlotState &s) { return Value(s.reading.status); }},
}};

constexpr int headSize = 2;
constexpr int stride = 5;
static_assert(areApart(head, headSize) && areApart(sensor, stride));

constexpr std::array<SlotPart, 1> parts{{{"", "", headSize, stride, sensor}}};

} // namespace

const UnitLayout &accelerationMap()
{
    static const UnitLayout layout{
        6,
        QT_TRANSLATE_NOOP("RegisterMap", "Accelerations"),
        QT_TRANSLATE_NOOP(
            "RegisterMap", "What is not valid keeps its last value, 0 if it never had one; the status word says so."),
        RegisterOrder::LowByteFirst,
        false,
        true,
        &SensorConfig::measuresAcceleration,
        head,
        parts,
    };
    return layout;
}

} // namespace gorizont
