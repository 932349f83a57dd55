// АН-Д3, ИН-Д and УСМ-ИСН: what manual 000 shows in figure 11.4 and table 11.1.

#include "core/opc/opcfields.h"
#include "core/values/statusword.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace gorizont {

namespace {

using namespace Qt::Literals::StringLiterals;

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(OpcTags)
};

/// A bit of the device's own word (spec/and3.md); of sensors that have none, what the status word says of the same.
struct StateBit
{
    const char *leaf; ///< figure 11.4
    const char *alias; ///< table 11.1; nullptr: the same
    int rawBit;
    const char *description;
    bool (*isSet)(quint16 status); ///< by the status word of the program
};

bool hasCode(quint16 status, StatusCode code)
{
    return statusCode(status) == code;
}

/// Restart keeps the sense that the АН-Д3 gives it: set once the restart was acknowledged.
constexpr std::array<StateBit, 8> stateBits{{
    {"Restart", nullptr, 0, QT_TRANSLATE_NOOP("OpcTags", "the restart was acknowledged"),
     [](quint16 status) { return (status & statusbit::Rebooted) == 0; }},
    {"ReadyAngl", nullptr, 1, QT_TRANSLATE_NOOP("OpcTags", "angles are ready"),
     [](quint16 status) { return isTiltValid(status); }},
    {"ReadyTmp", "ReadyTmpr", 2, QT_TRANSLATE_NOOP("OpcTags", "temperature is ready"),
     [](quint16 status) { return isTemperatureValid(status); }},
    {"ReadErr", nullptr, 4, QT_TRANSLATE_NOOP("OpcTags", "the transducer does not answer"),
     [](quint16 status) { return hasCode(status, StatusCode::TransducerSilent); }},
    {"CRCErr", nullptr, 5, QT_TRANSLATE_NOOP("OpcTags", "CRC errors of the transducer"),
     [](quint16 status) { return hasCode(status, StatusCode::TransducerCrc); }},
    {"RangdErr", "RangErr", 6, QT_TRANSLATE_NOOP("OpcTags", "the transducer is out of range"),
     [](quint16 status) { return hasCode(status, StatusCode::TransducerRange); }},
    {"TReadErr", nullptr, 8, QT_TRANSLATE_NOOP("OpcTags", "temperature cannot be read"),
     [](quint16 status) { return hasCode(status, StatusCode::TemperatureSensor); }},
    {"TRangErr", nullptr, 9, QT_TRANSLATE_NOOP("OpcTags", "temperature is out of range"),
     [](quint16 status) { return hasCode(status, StatusCode::TemperatureRange); }},
}};

QList<OpcField> stateFields(bool hasAliases)
{
    QList<OpcField> fields;
    for (const StateBit &bit : stateBits) {
        OpcField field;
        field.path = u"STATE."_s + QLatin1String(bit.leaf);
        if (hasAliases) {
            field.alias = u"STATUS."_s + QLatin1String(bit.alias != nullptr ? bit.alias : bit.leaf);
        }
        field.description = Text::tr(bit.description);
        field.type = OpcType::Bool;
        field.read = [bit](const Reading &reading) -> OpcFieldValue {
            if (reading.rawStatus) {
                return {((*reading.rawStatus >> bit.rawBit) & 1) != 0};
            }
            return {bit.isSet(reading.status)};
        };
        fields.append(field);
    }
    return fields;
}

template <typename Struct> OpcValue partOf(const std::optional<Struct> &values, double Struct::*part)
{
    return values ? OpcValue((*values).*part) : OpcValue();
}

constexpr std::array transducerFaults{
    StatusCode::TransducerSilent, StatusCode::TransducerCrc, StatusCode::TransducerRange};
constexpr std::array thermometerFaults{StatusCode::TemperatureSensor, StatusCode::TemperatureRange};

/// A value whose validity the status word tells; \a faults: the codes that put the blame on what measures it.
template <typename Faults>
OpcFieldValue validOr(const OpcValue &value, bool isValid, const Reading &reading, const Faults &faults)
{
    if (isValid) {
        return {value, OpcQuality::Good};
    }
    const bool isFaulty = std::ranges::find(faults, statusCode(reading.status)) != faults.end();
    return {value, isFaulty ? OpcQuality::SensorFailure : OpcQuality::WaitingForInitialData};
}

OpcField data(const char *leaf, const char *alias, const QString &description)
{
    OpcField field;
    field.path = u"DATA."_s + QLatin1String(leaf);
    if (alias != nullptr) {
        field.alias = u"DATA."_s + QLatin1String(alias);
    }
    field.description = description;
    return field;
}

OpcField angle(const char *leaf, const QString &description, double Tilt::*axis)
{
    OpcField field = data(leaf, nullptr, description);
    field.read = [axis](const Reading &reading) {
        return validOr(partOf(reading.tilt, axis), isTiltValid(reading.status), reading, transducerFaults);
    };
    return field;
}

OpcField acceleration(const char *leaf, const char *alias, const QString &description, double AccelStatistics::*part)
{
    OpcField field = data(leaf, alias, description);
    field.read = [part](const Reading &reading) {
        return validOr(
            partOf(reading.acceleration, part), isAccelerationValid(reading.status), reading, transducerFaults);
    };
    return field;
}

/// The status word holds one code; the word of an АН-Д3 says of its thermometer what another code may hide.
OpcFieldValue temperatureOf(const Reading &reading)
{
    constexpr quint16 rawFaults = 1 << 8 | 1 << 9;
    const OpcValue known = reading.temperature ? OpcValue(*reading.temperature) : OpcValue();
    OpcFieldValue value = validOr(known, isTemperatureValid(reading.status), reading, thermometerFaults);
    if (value.quality == OpcQuality::WaitingForInitialData && (reading.rawStatus.value_or(0) & rawFaults) != 0) {
        value.quality = OpcQuality::SensorFailure;
    }
    return value;
}

/// What a sensor is not there to measure.
OpcField outOfService(OpcField field)
{
    field.read = [](const Reading &) { return OpcFieldValue{{}, OpcQuality::OutOfService}; };
    return field;
}

OpcField temperature(const char *leaf, const char *alias)
{
    OpcField field = data(leaf, alias, Text::tr("temperature, °C"));
    field.read = temperatureOf;
    return field;
}

OpcField reserve(const char *leaf, const char *alias)
{
    OpcField field = data(leaf, alias, Text::tr("reserve"));
    field.read = [](const Reading &) { return OpcFieldValue{0.0}; };
    return field;
}

/// 8_Reserv has no meaning in the manual, yet a value in figure 11.4; here it counts the packets fetched from the ring, so
/// that a client sees the samples flow.
OpcField packets()
{
    OpcField field = data("8_Reserv", nullptr, Text::tr("packets of accelerations read since the start"));
    field.read = [](const Reading &reading) -> OpcFieldValue {
        return {reading.ring ? static_cast<double>(reading.ring->packetsRead) : 0.0};
    };
    return field;
}

QList<OpcField> angles()
{
    return {
        angle("Angl_X", Text::tr("angle X, arc-seconds"), &Tilt::x),
        angle("Angl_Y", Text::tr("angle Y, arc-seconds"), &Tilt::y)};
}

QList<OpcField> and3Data(const SensorConfig &sensor)
{
    QList<OpcField> accelerations{
        acceleration("AMax_X", "Amax_X", Text::tr("largest acceleration, X, mm/s²"), &AccelStatistics::maximumX),
        acceleration("AMax_Y", "Amax_Y", Text::tr("largest acceleration, Y, mm/s²"), &AccelStatistics::maximumY),
        acceleration("ARms_X", nullptr, Text::tr("RMS of acceleration, X, mm/s²"), &AccelStatistics::rmsX),
        acceleration("ARms_Y", "Arms_Y", Text::tr("RMS of acceleration, Y, mm/s²"), &AccelStatistics::rmsY)};
    if (!sensor.measuresAcceleration) {
        std::transform(accelerations.begin(), accelerations.end(), accelerations.begin(), outOfService);
    }
    const OpcField warmth = temperature("Temper", "Rezerv");
    return angles() + accelerations
        + QList<OpcField>{sensor.measuresTemperature ? warmth : outOfService(warmth), packets()};
}

/// An ИН-Д3 has neither accelerations nor a temperature: their places are reserves.
QList<OpcField> ind3Data()
{
    return angles() + QList<OpcField>{reserve("3_Reserv", "Amax_X"), reserve("4_Reserv", "Amax_Y"),
                                      reserve("5_Reserv", "ARms_X"), reserve("6_Reserv", "Arms_Y"),
                                      reserve("7_Reserv", "Rezerv"), reserve("8_Reserv", nullptr)};
}

OpcField variation(const char *leaf, const QString &description, double TiltVariation::*axis)
{
    OpcField field = data(leaf, nullptr, description);
    field.read = [axis](const Reading &reading) {
        return validOr(partOf(reading.variation, axis), isTiltValid(reading.status), reading, transducerFaults);
    };
    return field;
}

QList<OpcField> usmData()
{
    return angles()
        + QList<OpcField>{
            variation("Var_X", Text::tr("variation of angle X, degrees"), &TiltVariation::x),
            variation("Var_Y", Text::tr("variation of angle Y, degrees"), &TiltVariation::y),
            temperature("Temper", nullptr)};
}

OpcField displacement(const char *leaf, const QString &description, double Displacement::*axis)
{
    OpcField field = data(leaf, nullptr, description);
    field.read = [axis](const Reading &reading) -> OpcFieldValue {
        if (reading.displacement && reading.displacement->sum) {
            return {(*reading.displacement->sum).*axis};
        }
        return {};
    };
    return field;
}

QList<OpcField> chainData()
{
    return {
        displacement("Displ_X", Text::tr("displacement over the foot of the chain, X, mm"), &Displacement::x),
        displacement("Displ_Y", Text::tr("displacement over the foot of the chain, Y, mm"), &Displacement::y)};
}

} // namespace

namespace opcfield {

QList<OpcField> ofTilt(const SensorConfig &sensor)
{
    QList<OpcField> fields = stateFields(sensor.type != SensorType::UsmIsn);
    switch (sensor.type) {
    case SensorType::AnD3: fields += and3Data(sensor); break;
    case SensorType::UsmIsn: fields += usmData(); break;
    default: fields += ind3Data(); break;
    }
    return sensor.isInChain ? fields + chainData() : fields;
}

} // namespace opcfield

} // namespace gorizont
