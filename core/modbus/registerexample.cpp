#include "core/modbus/registerexample.h"

#include "core/modbus/markdowntable.h"
#include "core/modbus/modbusanswer.h"
#include "core/modbus/registervalue.h"
#include "core/values/statustext.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(RegisterMap)
};

QString hexOf(QByteArrayView bytes)
{
    return QLatin1Char('`') + QString::fromLatin1(bytes.toByteArray().toHex(' ').toUpper()) + QLatin1Char('`');
}

/// The status word of a sensor that answers with all that it measures.
quint16 goodWord(const SensorConfig &sensor, const StatusRules &rules)
{
    SensorConfig polled = sensor;
    polled.isOn = true;
    SensorSituation situation;
    situation.line = LineState::Open;
    situation.hasAnswered = true;
    situation.hasTilt = true;
    situation.hasTemperature = true;
    situation.hasAcceleration = true;
    return sensorWord(polled, situation, rules);
}

Weather exampleWeather()
{
    WeatherParameter direction;
    direction.code = weathercode::windDirection;
    direction.mean = 187.5;
    direction.deviation = 12.5;
    WeatherParameter speed;
    speed.code = weathercode::windSpeed;
    speed.mean = 4.75;
    speed.maxPeriod = 9.0;
    speed.deviation = 0.75;
    return {1, {direction, speed}, {}};
}

Reading exampleReading(const SensorConfig &sensor, const StatusRules &rules)
{
    Reading reading;
    reading.number = sensor.number;
    reading.isAnswer = true;
    reading.time = utcNow();
    reading.status = goodWord(sensor, rules);
    reading.tilt = Tilt{-264.0, -6644.6};
    if (sensor.measuresTemperature) {
        reading.temperature = 21.38;
    }
    AccelStatistics statistics;
    statistics.maximum = 7.67;
    statistics.maximumY = -7.67;
    statistics.direction = 270.0;
    statistics.rms = 2.19;
    statistics.rmsY = 2.19;
    reading.acceleration = statistics;
    if (sensor.measuresWeather) {
        reading.weather = exampleWeather();
    }
    return reading;
}

/// The fields that the example asks for: the angles where there is more than a request holds comfortably.
std::span<const SlotField> exampleFields(const SlotPart &part)
{
    const auto first = std::ranges::find_if(part.fields, [](const SlotField &field) {
        return QLatin1String(field.name) == QLatin1String("tilt_x_arcsec");
    });
    return first == part.fields.end() ? part.fields : std::span(first, 2);
}

std::optional<int> exampleSlot(const UnitImage &unit)
{
    const SensorSlots &slotMap = unit.slotMap();
    for (int slot = 0; slot < slotMap.count(); ++slot) {
        const SensorConfig &sensor = slotMap.at(slot).sensor;
        if (!slotMap.at(slot).isHole() && (unit.layout().member != nullptr || sensor.measuresTilt)) {
            return slot;
        }
    }
    return std::nullopt;
}

QByteArray requestFor(int unit, int address, int quantity)
{
    QByteArray request = QByteArray::fromHex("000100000006");
    for (const int byte : {unit, 4, address >> 8, address & 0xFF, quantity >> 8, quantity & 0xFF}) {
        request.append(static_cast<char>(static_cast<unsigned char>(byte)));
    }
    return request;
}

QString valueText(const SlotField &field, double value)
{
    if (field.type == RegisterType::Float32) {
        return QStringLiteral("%1 %2").arg(QString::number(value, 'g', 7), Text::tr(field.unit));
    }
    const auto whole = registerValue<qint64>(value, field.scale);
    if (*field.unit == '\0') {
        return QStringLiteral("%1h").arg(whole, 4, 16, QLatin1Char('0')).toUpper().replace(u'H', u'h');
    }
    return QStringLiteral("%1 × %2 %3")
        .arg(QString::number(whole), QString::number(1 / field.scale), Text::tr(field.unit));
}

/// What is asked for, and where it lies.
struct Question
{
    SlotState state;
    std::span<const SlotField> fields;
    int start; ///< register where the sensor's part of the block starts
    int address;
    int quantity;
};

Question questionAbout(const UnitImage &unit, int slot, const StatusRules &rules)
{
    const SlotPart &part = unit.layout().parts.back();
    const std::span<const SlotField> fields = exampleFields(part);
    const int start = unit.block().base() + part.start + part.stride * slot;
    const int address = start + fields.front().offset;
    const int end = start + fields.back().offset + registerCount(fields.back().type);
    Question question{SlotState(unit.slotMap().at(slot)), fields, start, address, end - address};
    question.state.take(exampleReading(question.state.slot.sensor, rules));
    return question;
}

QString answerTable(const Question &question, QByteArrayView answer)
{
    MarkdownTable table({Text::tr("Bytes of the answer"), Text::tr("What they are")});
    table.add({hexOf(answer.first(2)), Text::tr("transaction, as in the request")});
    table.add({hexOf(answer.sliced(2, 2)), Text::tr("protocol, as in the request")});
    table.add({hexOf(answer.sliced(4, 2)), Text::tr("how many bytes follow")});
    table.add({hexOf(answer.sliced(6, 1)), Text::tr("unit")});
    table.add({hexOf(answer.sliced(7, 1)), Text::tr("function")});
    table.add({hexOf(answer.sliced(8, 1)), Text::tr("how many bytes of data follow")});
    for (const SlotField &field : question.fields) {
        const int at = 9 + 2 * (question.start + field.offset - question.address);
        const QString value = valueText(field, field.value(question.state).value_or(0));
        table.add(
            {hexOf(answer.sliced(at, 2 * qsizetype{registerCount(field.type)})),
             QStringLiteral("`%1` = %2").arg(QLatin1String(field.name), value)});
    }
    return table.text();
}

} // namespace

QString byteOrder(RegisterType type, RegisterOrder order)
{
    QString letters = QStringLiteral("ABCDEFGH").first(2 * qsizetype{registerCount(type)});
    if (order == RegisterOrder::LowByteFirst) {
        std::reverse(letters.begin(), letters.end());
    }
    return letters;
}

QString registerExample(const ModbusConfig &config, const UnitImage &unit)
{
    const std::optional<int> slot = exampleSlot(unit);
    if (!slot) {
        return {};
    }
    const Question question = questionAbout(unit, *slot, config.rules);
    UnitImages images(config);
    images.update(question.state.reading);
    const QByteArray request = requestFor(unit.layout().unit, question.address, question.quantity);
    AnswerBuffer answer;
    answerRequests(request, images, answer);
    const QByteArrayView bytes(answer.constData(), answer.size());

    const QString title = Text::tr("Example: function 04, %1 registers from register %2, of sensor N=%3")
                              .arg(question.quantity)
                              .arg(question.address)
                              .arg(question.state.reading.number);
    return QStringLiteral("### %1\n\n- %2: %3\n- %4: %5\n\n%6")
        .arg(
            title, Text::tr("Request"), hexOf(request), Text::tr("Answer"), hexOf(bytes), answerTable(question, bytes));
}

} // namespace gorizont
