#include "core/devices/usmisn/usmisnprotocol.h"

#include <algorithm>

namespace gorizont::usmisn {

namespace {

constexpr qsizetype valueFields = 11;
constexpr qsizetype channelFields = 4;
constexpr qsizetype longestNumber = 12; ///< digits, of any number of the manual

/// Empty: not one to twelve digits, or above \a most.
std::optional<quint64> whole(const QByteArray &field, quint64 most)
{
    if (field.isEmpty() || field.size() > longestNumber) {
        return std::nullopt;
    }
    quint64 number = 0;
    for (const char c : field) {
        if (c < '0' || c > '9') {
            return std::nullopt;
        }
        number = 10 * number + static_cast<quint64>(c - '0');
    }
    return number <= most ? std::optional(number) : std::nullopt;
}

constexpr quint64 most32 = 0xFFFFFFFF;
constexpr quint64 mostChannel = 999'999'999'999;

/// Digits, a point, digits, with a minus in front; how the device writes the sign of a positive number is not known, so a plus
/// is as good as nothing.
std::optional<double> decimal(const QByteArray &field)
{
    const bool isSigned = field.startsWith('-') || field.startsWith('+');
    const QByteArray digits = isSigned ? field.sliced(1) : field;
    const QByteArrayList halves = digits.split('.');
    if (halves.size() != 2 || !whole(halves.first(), mostChannel) || !whole(halves.last(), mostChannel)) {
        return std::nullopt;
    }
    const double number = digits.toDouble();
    return field.startsWith('-') ? -number : number;
}

/// `32` and `032` are one number.
bool isSame(const QByteArray &sent, const QByteArray &back)
{
    const auto number = whole(sent, mostChannel);
    return sent == back || (number && number == whole(back, mostChannel));
}

QString textOf(const QByteArray &field)
{
    return QString::fromLatin1(field);
}

/// The only field of an answer; Refused: it is a keyword.
Result<QByteArray> single(QByteArrayView bytes, const Question &question)
{
    const auto answer = decodeAnswer(bytes, question);
    if (!answer || answer->fields.size() != 1) {
        return Fault::BadReply;
    }
    const QByteArray &field = answer->fields.constFirst();
    return field.startsWith("Error") ? Result<QByteArray>(Fault::Refused) : field;
}

Result<quint64> singleNumber(QByteArrayView bytes, const Question &question, quint64 most)
{
    const auto field = single(bytes, question);
    if (!field) {
        return field.fault();
    }
    const auto number = whole(*field, most);
    return number ? Result<quint64>(*number) : Fault::BadReply;
}

template <typename T> Result<T> as(const Result<quint64> &number)
{
    return number ? Result<T>(static_cast<T>(*number)) : number.fault();
}

std::optional<ValueState> errorNamed(const QByteArray &field)
{
    if (field == "ErrorSensor") {
        return ValueState::ErrorSensor;
    }
    if (field == "ErrorCH") {
        return ValueState::ErrorChannel;
    }
    return field == "ErrorData" ? std::optional(ValueState::ErrorData) : std::nullopt;
}

Result<Value> valueOf(const QByteArrayList &fields)
{
    if (fields.size() != valueFields) {
        return Fault::BadReply;
    }
    const bool isOut = fields.at(3) == "OutOfRange";
    const auto timestamp = whole(fields.at(0), mostChannel);
    const auto channel = whole(fields.at(1), mostChannel);
    const auto measurement = whole(fields.at(2), most32);
    const auto value = isOut ? 0.0 : decimal(fields.at(3));
    const auto variation = decimal(fields.at(4));
    const auto temperature = decimal(fields.at(5));
    const auto gain = whole(fields.at(9), 999);
    const auto voltage = whole(fields.at(10), 999);
    if (!timestamp || !channel || !measurement || !value || !variation || !temperature || !gain || !voltage) {
        return Fault::BadReply;
    }
    Value result;
    result.state = isOut ? ValueState::OutOfRange : ValueState::Measured;
    result.timestamp = static_cast<qint64>(*timestamp);
    result.channel = {*channel};
    result.measurement = static_cast<quint32>(*measurement);
    result.value = *value;
    result.variation = *variation;
    result.temperature = *temperature;
    result.description = textOf(fields.at(8));
    result.gain = static_cast<int>(*gain);
    result.voltage = static_cast<int>(*voltage);
    return result;
}

QByteArray stopBitsText(StopBits stopBits)
{
    switch (stopBits) {
    case StopBits::One: return "1";
    case StopBits::OneAndHalf: return "1_5";
    case StopBits::Two: break;
    }
    return "2";
}

QByteArray parityText(Parity parity)
{
    return parity == Parity::Even ? "E" : parity == Parity::Odd ? "O" : "N";
}

} // namespace

Request Ask::request() const
{
    return {bytes(), [question = question](QByteArrayView received) { return scanAnswer(received, question); }};
}

Ask Asking::with(Instruction instruction, const QByteArray &data) const
{
    return {{m_address, m_transaction, instruction}, data};
}

Ask Asking::plain(Instruction instruction) const
{
    return with(instruction, {});
}

std::optional<Ask> Asking::setAddress(int newAddress) const
{
    if (!isAddress(newAddress)) {
        return std::nullopt;
    }
    return with(Instruction::SetAddress, QByteArray::number(newAddress));
}

std::optional<Ask> Asking::setPortSettings(const PortSettings &port) const
{
    if (!isPossible(port)) {
        return std::nullopt;
    }
    const QByteArrayList fields{
        QByteArray::number(port.baudRate), parityText(port.parity), stopBitsText(port.stopBits)};
    return with(Instruction::SetPortSettings, fields.join(','));
}

std::optional<Ask> Asking::getValue(quint64 channel, qint64 timestamp) const
{
    if (channel == 0 || channel > mostChannel || timestamp < 0 || timestamp > qint64(most32)) {
        return std::nullopt;
    }
    return with(Instruction::GetValue, QByteArray::number(timestamp) + ',' + QByteArray::number(channel));
}

std::optional<Ask> Asking::getRecord(int count, RecordMask mask, quint64 channel) const
{
    if (count < 0 || count > mostCounted || channel == 0 || channel > mostChannel) {
        return std::nullopt;
    }
    const QByteArrayList fields{
        QByteArray::number(count), mask == RecordMask::All ? "ALL" : "NEW", QByteArray::number(channel)};
    return with(Instruction::GetRecord, fields.join(','));
}

std::optional<Ask> Asking::startCycle(const Recording &recording) const
{
    if (!isPossible(recording)) {
        return std::nullopt;
    }
    const QByteArrayList fields{
        QByteArray::number(recording.now), QByteArray::number(recording.start),
        QByteArray::number(qint64(recording.period.count())), QByteArray::number(qint64(recording.delay.count()))};
    return with(Instruction::StartCycle, fields.join(','));
}

Result<quint32> decodeSerial(QByteArrayView bytes, const Question &question)
{
    return as<quint32>(singleNumber(bytes, question, 99'999'999));
}

Result<int> decodeType(QByteArrayView bytes, const Question &question)
{
    return as<int>(singleNumber(bytes, question, 999));
}

Result<QDate> decodeProgVersion(QByteArrayView bytes, const Question &question)
{
    const auto field = single(bytes, question);
    if (!field) {
        return field.fault();
    }
    const QByteArrayList parts = field->split('.');
    if (parts.size() != 3) {
        return Fault::BadReply;
    }
    const auto day = whole(parts.at(0), 31);
    const auto month = whole(parts.at(1), 12);
    const auto year = whole(parts.at(2), 99);
    const QDate date = day && month && year ? QDate(2000 + int(*year), int(*month), int(*day)) : QDate();
    return date.isValid() ? Result<QDate>(date) : Fault::BadReply;
}

/// The days of spreadsheets, that begin on 30.12.1899, not on 01.01.1900 as the manual says: 42839 is 14.04.2017 there too.
Result<QDate> decodeDateCalibration(QByteArrayView bytes, const Question &question)
{
    constexpr quint64 mostDays = 2'958'465; // end of 9999
    const auto days = singleNumber(bytes, question, mostDays);
    return days ? Result<QDate>(QDate(1899, 12, 30).addDays(qint64(*days))) : days.fault();
}

Result<quint32> decodeCountCalibration(QByteArrayView bytes, const Question &question)
{
    return as<quint32>(singleNumber(bytes, question, most32));
}

Result<std::optional<Channel>> decodeInfo(QByteArrayView bytes, const Question &question)
{
    const auto answer = decodeAnswer(bytes, question);
    if (!answer) {
        return Fault::BadReply;
    }
    const QByteArrayList &fields = answer->fields;
    if (fields.size() == 1) {
        const bool isEnd = fields.constFirst() == "End";
        return isEnd                          ? Result<std::optional<Channel>>(std::nullopt)
            : errorNamed(fields.constFirst()) ? Fault::Refused
                                              : Fault::BadReply;
    }
    const auto id = fields.size() == channelFields ? whole(fields.at(0), mostChannel) : std::nullopt;
    if (!id) {
        return Fault::BadReply;
    }
    return std::optional(Channel{{*id}, textOf(fields.at(1)), textOf(fields.at(2)), textOf(fields.at(3))});
}

Result<int> decodeAddress(QByteArrayView bytes, const Question &question)
{
    return as<int>(singleNumber(bytes, question, 255));
}

Result<Value> decodeValue(QByteArrayView bytes, const Question &question)
{
    const auto answer = decodeAnswer(bytes, question);
    if (!answer) {
        return Fault::BadReply;
    }
    if (answer->fields.size() != 1) {
        return valueOf(answer->fields);
    }
    const auto error = errorNamed(answer->fields.constFirst());
    if (!error) {
        return Fault::BadReply;
    }
    Value value;
    value.state = *error;
    return value;
}

Result<std::optional<Value>> decodeRecord(QByteArrayView bytes, const Question &question)
{
    const auto answer = decodeAnswer(bytes, question);
    if (!answer) {
        return Fault::BadReply;
    }
    if (answer->fields.size() == 1) {
        const bool isEnd = answer->fields.constFirst() == "End";
        return isEnd                                  ? Result<std::optional<Value>>(std::nullopt)
            : errorNamed(answer->fields.constFirst()) ? Fault::Refused
                                                      : Fault::BadReply;
    }
    const auto value = valueOf(answer->fields);
    return value ? Result<std::optional<Value>>(*value) : value.fault();
}

Result<quint32> decodeCrc(QByteArrayView bytes, const Question &question)
{
    return as<quint32>(singleNumber(bytes, question, most32));
}

Result<void> decodeEcho(QByteArrayView bytes, const Ask &ask)
{
    const auto answer = decodeAnswer(bytes, ask.question);
    if (!answer) {
        return Fault::BadReply;
    }
    if (errorNamed(answer->fields.constFirst())) {
        return Fault::Refused;
    }
    const QByteArrayList sent = ask.data.split(',');
    return std::equal(sent.begin(), sent.end(), answer->fields.begin(), answer->fields.end(), isSame) ? Result<void>()
                                                                                                      : Fault::BadReply;
}

int addressOf(QByteArrayView bytes, const Question &question)
{
    const auto answer = decodeAnswer(bytes, question);
    return answer ? answer->address : everybody;
}

} // namespace gorizont::usmisn
