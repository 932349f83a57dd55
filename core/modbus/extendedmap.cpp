#include "core/modbus/extendedmap.h"

#include "core/modbus/extendedcodes.h"
#include "core/values/wind.h"

#include <QtGlobal>

#include <algorithm>
#include <limits>

namespace gorizont {

namespace {

using Value = std::optional<double>;
using enum RegisterType;

constexpr int version = 1;
constexpr quint32 magic = 0x474F525A; ///< "GORZ"
constexpr int directoryStart = 100;
constexpr int directoryStride = 4;
constexpr int blockStart = 3000;
constexpr int blockStride = 100;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
/// Saturates every integer.
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double arcSecondsPerDegree = 3600;

double milliseconds(UtcTime time)
{
    return static_cast<double>(std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count());
}

double seconds(std::chrono::microseconds duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// A counter goes on from 0 after 4294967295.
double wrapped(quint64 counter)
{
    return static_cast<quint32>(counter);
}

template <double Tilt::*member> Value tilt(const SlotState &s)
{
    return hasTilt(s) ? (*s.reading.tilt).*member : absent;
}
template <double Tilt::*member> Value tiltInDegrees(const SlotState &s)
{
    return *tilt<member>(s) / arcSecondsPerDegree;
}
template <double AccelStatistics::*member> Value acceleration(const SlotState &s)
{
    return hasAcceleration(s) ? (*s.reading.acceleration).*member : absent;
}
template <quint64 SensorCounters::*member> Value counter(const SlotState &s)
{
    return wrapped(s.reading.counters.*member);
}
template <quint64 RingProgress::*member> Value packets(const SlotState &s)
{
    return s.reading.ring ? wrapped((*s.reading.ring).*member) : 0;
}
template <double Displacement::*member> Value ownDisplacement(const SlotState &s)
{
    return hasTilt(s) && s.reading.displacement ? s.reading.displacement->own.*member : absent;
}
template <double Displacement::*member> Value displacement(const SlotState &s)
{
    return hasTilt(s) && s.reading.displacement && s.reading.displacement->sum ? (*s.reading.displacement->sum).*member
                                                                               : absent;
}
template <std::optional<double> Wind::*member> Value wind(const SlotState &s)
{
    return hasWeather(s) ? (windOf(*s.reading.weather).*member).value_or(absent) : absent;
}
template <char16_t code> Value weather(const SlotState &s)
{
    return hasWeather(s) ? meanOf(*s.reading.weather, code).value_or(absent) : absent;
}
template <std::chrono::microseconds Reading::*member> Value turn(const SlotState &s)
{
    return (s.reading.*member).count() > 0 ? seconds(s.reading.*member) : absent;
}

Value number(const SlotState &s)
{
    return s.slot.sensor.number;
}
Value status(const SlotState &s)
{
    return s.reading.status;
}

quint16 word(std::span<const SlotBit> bits, const SlotState &s)
{
    unsigned result = 0;
    for (const SlotBit &bit : bits) {
        result |= bit.isSet(s) ? 1U << bit.bit : 0U;
    }
    return static_cast<quint16>(result);
}
Value flags(const SlotState &s)
{
    return word(extendedFlags(), s);
}

Value typeCode(const SlotState &s)
{
    const auto types = extendedTypes();
    const auto found = std::ranges::find(types, s.slot.sensor.type, &TypeCode::type);
    return found != types.end() ? found->code : 0;
}

double age(const SlotState &s, const Moment &now)
{
    if (!s.reading.answeredAt) {
        return endless;
    }
    return std::chrono::duration<double, std::milli>(std::max(now.steady - *s.reading.answeredAt, {})).count();
}

template <int code> constexpr HeadField codeCount(const char *name)
{
    return {
        20 + code,
        UInt16,
        1,
        name,
        "",
        QT_TRANSLATE_NOOP("RegisterMap", "How many sensors have this status code"),
        [](const HeadState &s) { return Value(s.withCode[code]); }};
}

constexpr std::array<HeadField, 25> head{{
    {0, UInt32, 1, "magic", "", QT_TRANSLATE_NOOP("RegisterMap", "474F525Ah, the letters GORZ: this is the map"),
     [](const HeadState &) { return Value(magic); }},
    {2, UInt16, 1, "version", "", QT_TRANSLATE_NOOP("RegisterMap", "Version of the layout"),
     [](const HeadState &) { return Value(version); }},
    {3, UInt16, 1, "slots", "", QT_TRANSLATE_NOOP("RegisterMap", "How many slots there are"),
     [](const HeadState &s) { return Value(s.slotCount); }},
    {4, UInt16, 1, "directory", "", QT_TRANSLATE_NOOP("RegisterMap", "Register where the directory starts"),
     [](const HeadState &) { return Value(directoryStart); }},
    {5, UInt16, 1, "directory_step", "", QT_TRANSLATE_NOOP("RegisterMap", "Registers of an entry of the directory"),
     [](const HeadState &) { return Value(directoryStride); }},
    {6, UInt16, 1, "blocks", "", QT_TRANSLATE_NOOP("RegisterMap", "Register where the block of slot 0 starts"),
     [](const HeadState &) { return Value(blockStart); }},
    {7, UInt16, 1, "block_step", "", QT_TRANSLATE_NOOP("RegisterMap", "Registers of a block"),
     [](const HeadState &) { return Value(blockStride); }},
    {8, UInt64, 1, "server_time", QT_TRANSLATE_NOOP("RegisterMap", "ms"),
     QT_TRANSLATE_NOOP("RegisterMap", "Time of the answer, UTC, since 1970"), nullptr,
     [](const HeadState &, const Moment &now) { return milliseconds(now.utc); }},
    {12, UInt32, 1, "uptime", QT_TRANSLATE_NOOP("RegisterMap", "s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Since the program started"), nullptr,
     [](const HeadState &s, const Moment &now) {
         return static_cast<double>(std::chrono::floor<std::chrono::seconds>(now.steady - s.started).count());
     }},
    {14, UInt32, 1, "channels", "", QT_TRANSLATE_NOOP("RegisterMap", "Channel word: two bits a port"),
     [](const HeadState &s) { return Value(s.channels); }},
    {16, UInt16, 1, "sensors", "", QT_TRANSLATE_NOOP("RegisterMap", "How many sensors there are"),
     [](const HeadState &s) { return Value(s.sensors); }},
    {17, UInt16, 1, "current", "", QT_TRANSLATE_NOOP("RegisterMap", "How many of them answer"),
     [](const HeadState &s) { return Value(s.current); }},
    {18, UInt16, 1, "switched_off", "", QT_TRANSLATE_NOOP("RegisterMap", "How many of them are switched off"),
     [](const HeadState &s) { return Value(s.switchedOff); }},
    codeCount<0>("code_0"),
    codeCount<1>("code_1"),
    codeCount<2>("code_2"),
    codeCount<3>("code_3"),
    codeCount<4>("code_4"),
    codeCount<5>("code_5"),
    codeCount<6>("code_6"),
    codeCount<7>("code_7"),
    codeCount<8>("code_8"),
    codeCount<9>("code_9"),
    codeCount<10>("code_10"),
    codeCount<11>("code_11"),
}};

constexpr std::array<SlotField, 3> directory{{
    {0, UInt32, 1, "number", "", QT_TRANSLATE_NOOP("RegisterMap", "Site number N; 0: an empty slot"), number},
    {2, UInt16, 1, "status", "", QT_TRANSLATE_NOOP("RegisterMap", "Status word of the sensor"), status},
    {3, UInt16, 1, "flags", "", QT_TRANSLATE_NOOP("RegisterMap", "Flags of the slot"), flags},
}};

constexpr std::array<SlotField, 43> block{{
    {0, UInt32, 1, "number", "", QT_TRANSLATE_NOOP("RegisterMap", "Site number N; 0: an empty slot"), number},
    {2, UInt16, 1, "port", "", QT_TRANSLATE_NOOP("RegisterMap", "Number of the port in the ini, 1…16"),
     [](const SlotState &s) { return Value(s.slot.sensor.port); }},
    {3, UInt16, 1, "address", "", QT_TRANSLATE_NOOP("RegisterMap", "Address on the line"),
     [](const SlotState &s) { return s.slot.isHole() ? Value(0) : Value(s.slot.sensor.address); }},
    {4, UInt16, 1, "type", "", QT_TRANSLATE_NOOP("RegisterMap", "Type of the sensor"), typeCode},
    {5, UInt16, 1, "flags", "", QT_TRANSLATE_NOOP("RegisterMap", "Flags of the slot"), flags},
    {6, UInt16, 1, "status", "", QT_TRANSLATE_NOOP("RegisterMap", "Status word of the sensor"), status},
    {7, UInt16, 1, "quantities", "", QT_TRANSLATE_NOOP("RegisterMap", "What the sensor measures"),
     [](const SlotState &s) { return Value(word(extendedQuantities(), s)); }},
    {8, UInt16, 1, "raw_status", "", QT_TRANSLATE_NOOP("RegisterMap", "The sensor's own status word"),
     [](const SlotState &s) { return Value(s.reading.rawStatus.value_or(0)); }},
    {9, UInt16, 1, "raw_mode", "", QT_TRANSLATE_NOOP("RegisterMap", "The sensor's own mode word"),
     [](const SlotState &s) { return Value(s.reading.rawMode.value_or(0)); }},
    {10, UInt32, 1, "age", QT_TRANSLATE_NOOP("RegisterMap", "ms"),
     QT_TRANSLATE_NOOP("RegisterMap", "Since the last answer; FFFFFFFFh: none so far"), nullptr, age},
    {12, UInt64, 1, "time", QT_TRANSLATE_NOOP("RegisterMap", "ms"),
     QT_TRANSLATE_NOOP("RegisterMap", "Time of the last answer, UTC, since 1970; 0: none so far"),
     [](const SlotState &s) { return s.answeredAt ? Value(milliseconds(*s.answeredAt)) : Value(0); }},
    {16, Float32, 1, "tilt_x_arcsec", "″", QT_TRANSLATE_NOOP("RegisterMap", "Tilt along X"), tilt<&Tilt::x>},
    {18, Float32, 1, "tilt_y_arcsec", "″", QT_TRANSLATE_NOOP("RegisterMap", "Tilt along Y"), tilt<&Tilt::y>},
    {20, Float32, 1, "tilt_x", "°", QT_TRANSLATE_NOOP("RegisterMap", "Tilt along X"), tiltInDegrees<&Tilt::x>},
    {22, Float32, 1, "tilt_y", "°", QT_TRANSLATE_NOOP("RegisterMap", "Tilt along Y"), tiltInDegrees<&Tilt::y>},
    {24, Float32, 1, "temperature", "°C", QT_TRANSLATE_NOOP("RegisterMap", "Temperature"),
     [](const SlotState &s) { return Value(hasTemperature(s) ? *s.reading.temperature : absent); }},
    {26, Float32, 1, "heater", "%", QT_TRANSLATE_NOOP("RegisterMap", "Power of the heater"),
     [](const SlotState &s) { return Value(s.isCurrent ? s.reading.heaterPower.value_or(absent) : absent); }},
    {28, Float32, 1, "fan", QT_TRANSLATE_NOOP("RegisterMap", "1/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Speed of the fan"),
     [](const SlotState &s) { return Value(s.isCurrent ? s.reading.fanFrequency.value_or(absent) : absent); }},
    {32, Float32, 1, "accel_max", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "Largest acceleration, modulus"), acceleration<&AccelStatistics::maximum>},
    {34, Float32, 1, "accel_direction", "°", QT_TRANSLATE_NOOP("RegisterMap", "Direction of the largest acceleration"),
     acceleration<&AccelStatistics::direction>},
    {36, Float32, 1, "accel_max_x", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "Component of the largest acceleration along X"),
     acceleration<&AccelStatistics::maximumX>},
    {38, Float32, 1, "accel_max_y", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "Component of the largest acceleration along Y"),
     acceleration<&AccelStatistics::maximumY>},
    {40, Float32, 1, "accel_rms", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "RMS of the acceleration, modulus"), acceleration<&AccelStatistics::rms>},
    {42, Float32, 1, "accel_rms_x", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "RMS of the acceleration along X"), acceleration<&AccelStatistics::rmsX>},
    {44, Float32, 1, "accel_rms_y", QT_TRANSLATE_NOOP("RegisterMap", "mm/s²"),
     QT_TRANSLATE_NOOP("RegisterMap", "RMS of the acceleration along Y"), acceleration<&AccelStatistics::rmsY>},
    {48, UInt32, 1, "answers", "", QT_TRANSLATE_NOOP("RegisterMap", "Answers since the program started"),
     counter<&SensorCounters::answers>},
    {50, UInt32, 1, "read_errors", "", QT_TRANSLATE_NOOP("RegisterMap", "Failed reads since the program started"),
     counter<&SensorCounters::readErrors>},
    {52, UInt32, 1, "crc_errors", "", QT_TRANSLATE_NOOP("RegisterMap", "Wrong check sums since the program started"),
     counter<&SensorCounters::crcErrors>},
    {54, UInt32, 1, "packets_measured", "",
     QT_TRANSLATE_NOOP("RegisterMap", "Packets of samples measured since the sensor started"),
     packets<&RingProgress::packetsMeasured>},
    {56, UInt32, 1, "packets_read", "",
     QT_TRANSLATE_NOOP("RegisterMap", "Packets of samples read since the program started"),
     packets<&RingProgress::packetsRead>},
    {60, Float32, 1, "period", QT_TRANSLATE_NOOP("RegisterMap", "s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Between the last two turns"), turn<&Reading::period>},
    {62, Float32, 1, "exchange", QT_TRANSLATE_NOOP("RegisterMap", "s"),
     QT_TRANSLATE_NOOP("RegisterMap", "How long the last turn took"), turn<&Reading::exchange>},
    {64, Float32, 1, "link_x", QT_TRANSLATE_NOOP("RegisterMap", "mm"),
     QT_TRANSLATE_NOOP("RegisterMap", "Displacement along X over the sensor's link of a chain"),
     ownDisplacement<&Displacement::x>},
    {66, Float32, 1, "link_y", QT_TRANSLATE_NOOP("RegisterMap", "mm"),
     QT_TRANSLATE_NOOP("RegisterMap", "Displacement along Y over the sensor's link of a chain"),
     ownDisplacement<&Displacement::y>},
    {68, Float32, 1, "displacement_x", QT_TRANSLATE_NOOP("RegisterMap", "mm"),
     QT_TRANSLATE_NOOP("RegisterMap", "Displacement along X over the foot of the chain"),
     displacement<&Displacement::x>},
    {70, Float32, 1, "displacement_y", QT_TRANSLATE_NOOP("RegisterMap", "mm"),
     QT_TRANSLATE_NOOP("RegisterMap", "Displacement along Y over the foot of the chain"),
     displacement<&Displacement::y>},
    {80, Float32, 1, "wind_speed", QT_TRANSLATE_NOOP("RegisterMap", "m/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Speed of the wind, mean"), wind<&Wind::speed>},
    {82, Float32, 1, "wind_direction", "°", QT_TRANSLATE_NOOP("RegisterMap", "Direction of the wind, mean"),
     wind<&Wind::direction>},
    {84, Float32, 1, "wind_max", QT_TRANSLATE_NOOP("RegisterMap", "m/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Largest speed of the wind in the last turns"), wind<&Wind::maximum>},
    {86, Float32, 1, "wind_deviation", QT_TRANSLATE_NOOP("RegisterMap", "m/s"),
     QT_TRANSLATE_NOOP("RegisterMap", "Standard deviation of the speed of the wind"), wind<&Wind::deviation>},
    {88, Float32, 1, "pressure", QT_TRANSLATE_NOOP("RegisterMap", "mm Hg"),
     QT_TRANSLATE_NOOP("RegisterMap", "Pressure of the air"), weather<u'P'>},
    {90, Float32, 1, "humidity", "%", QT_TRANSLATE_NOOP("RegisterMap", "Humidity of the air"), weather<u'H'>},
    {92, UInt32, 1, "digital", "",
     QT_TRANSLATE_NOOP("RegisterMap", "Digital inputs of a weather station, bit 0 the first"),
     [](const SlotState &s) { return Value(hasWeather(s) ? s.reading.weather->digital : 0); }},
}};

static_assert(areApart(head, directoryStart) && areApart(directory, directoryStride) && areApart(block, blockStride));

constexpr std::array<SlotPart, 2> parts{{
    {"directory", QT_TRANSLATE_NOOP("RegisterMap", "Directory"), directoryStart, directoryStride, directory},
    {"block", QT_TRANSLATE_NOOP("RegisterMap", "Blocks of the sensors"), blockStart, blockStride, block},
}};

} // namespace

const UnitLayout &extendedMap()
{
    static const UnitLayout layout{
        1,
        QT_TRANSLATE_NOOP("RegisterMap", "Extended map: every sensor of every type"),
        QT_TRANSLATE_NOOP(
            "RegisterMap",
            "A number that is absent or not valid now is NaN (7FC00000h) where the type is float32, and 0 with a flag "
            "otherwise. Registers that are not listed are reserved and read 0. One request is answered from one "
            "moment: "
            "a value that it reads whole is never torn."),
        RegisterOrder::HighByteFirst,
        true,
        false,
        nullptr,
        head,
        parts,
    };
    return layout;
}

} // namespace gorizont
