// МК-14: digital inputs and whatever parameters the station has (manual 004, section 4.2).

#include "core/opc/opcfields.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>

namespace gorizont {

namespace {

using namespace Qt::Literals::StringLiterals;

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(OpcTags)
};

constexpr int digitalInputs = 32;

struct Part
{
    const char *leaf;
    const char *description;
    std::optional<double> WeatherParameter::*value;
    bool isVoltage = false;
};

constexpr std::array<Part, 8> parts{{
    {"Mean", QT_TRANSLATE_NOOP("OpcTags", "mean"), &WeatherParameter::mean},
    {"Instant", QT_TRANSLATE_NOOP("OpcTags", "instantaneous value"), &WeatherParameter::instant},
    {"Min", QT_TRANSLATE_NOOP("OpcTags", "minimum"), &WeatherParameter::minimum},
    {"Max", QT_TRANSLATE_NOOP("OpcTags", "maximum"), &WeatherParameter::maximum},
    {"Voltage", QT_TRANSLATE_NOOP("OpcTags", "primary value, mean"), &WeatherParameter::voltage, true},
    {"VoltageInstant", QT_TRANSLATE_NOOP("OpcTags", "primary value, instantaneous"), &WeatherParameter::voltageInstant,
     true},
    {"MaxPeriod", QT_TRANSLATE_NOOP("OpcTags", "maximum since the last request"), &WeatherParameter::maxPeriod},
    {"Deviation", QT_TRANSLATE_NOOP("OpcTags", "standard deviation"), &WeatherParameter::deviation},
}};

QList<OpcField> inputFields()
{
    QList<OpcField> fields;
    for (int bit = 0; bit < digitalInputs; ++bit) {
        OpcField field;
        field.path = u"STATE.Input_%1"_s.arg(bit, 2, 10, QLatin1Char('0'));
        field.description = Text::tr("digital input, bit %1").arg(bit);
        field.type = OpcType::Bool;
        field.read = [bit](const Reading &reading) -> OpcFieldValue {
            return reading.weather ? OpcFieldValue{((reading.weather->digital >> bit) & 1) != 0} : OpcFieldValue{};
        };
        fields.append(field);
    }
    return fields;
}

OpcField precipitation()
{
    OpcField field;
    field.path = u"STATE.Precipitation"_s;
    field.description = Text::tr("it rains: the last event is a beginning");
    field.type = OpcType::Bool;
    field.read = [](const Reading &reading) -> OpcFieldValue {
        if (!reading.weather || reading.weather->events.isEmpty()) {
            return {};
        }
        return {reading.weather->events.first().isStart};
    };
    return field;
}

QString descriptionOf(const WeatherParameter &parameter, const Part &part)
{
    const QString name =
        parameter.name.isEmpty() ? QString(parameter.code) + QString::number(parameter.number) : parameter.name;
    const QString unit = part.isVoltage ? Text::tr("V or Hz") : parameter.unit;
    const QString text = name + u", "_s + Text::tr(part.description);
    return unit.isEmpty() ? text : text + u", "_s + unit;
}

} // namespace

namespace opcfield {

QList<OpcField> ofWeather(const QList<WeatherParameter> &parameters)
{
    QList<OpcField> fields = inputFields();
    fields.append(precipitation());
    for (const WeatherParameter &parameter : parameters) {
        for (const Part &part : parts) {
            OpcField field;
            field.path = u"DATA.%1_%2.%3"_s.arg(parameter.code).arg(parameter.number).arg(QLatin1String(part.leaf));
            field.description = descriptionOf(parameter, part);
            field.read = [code = parameter.code, number = parameter.number,
                          value = part.value](const Reading &reading) -> OpcFieldValue {
                const WeatherParameter *known = reading.weather ? reading.weather->find(code, number) : nullptr;
                return known != nullptr && (known->*value) ? OpcFieldValue{*(known->*value)} : OpcFieldValue{};
            };
            fields.append(field);
        }
    }
    return fields;
}

} // namespace opcfield

QList<WeatherParameter> weatherParameters(const SensorConfig &sensor)
{
    static const QRegularExpression word(u"^(\\p{L})([1-9]\\d{0,2})?$"_s);
    static const QRegularExpression separators(u"[\\s,;]+"_s);
    const QString usual = u"U,T,P,H,A,M"_s;
    for (const QString &list : {sensor.options.value(u"params"_s), usual}) {
        QList<WeatherParameter> parameters;
        QHash<QChar, int> last;
        bool isList = true;
        for (const QString &text : list.split(separators, Qt::SkipEmptyParts)) {
            const QRegularExpressionMatch match = word.match(text);
            isList = isList && match.hasMatch();
            const QChar code = text.front();
            const int number = match.captured(2).isEmpty() ? last.value(code) + 1 : match.captured(2).toInt();
            last[code] = std::max(last.value(code), number);
            WeatherParameter parameter;
            parameter.code = code;
            parameter.number = number;
            parameters.append(parameter);
        }
        if (isList && !parameters.isEmpty()) {
            return parameters;
        }
    }
    return {};
}

} // namespace gorizont
