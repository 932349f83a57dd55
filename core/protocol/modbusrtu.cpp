#include "core/protocol/modbusrtu.h"

#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"

namespace gorizont::modbusrtu {

namespace {

constexpr qsizetype envelope = 4; ///< address, function, CRC
constexpr qsizetype exceptionLength = envelope + 1;

/// A frame that would be an answer: what it begins with and how long it is.
struct Shape
{
    QByteArray head;
    qsizetype length = 0;
};

bool isWrite(const QModbusPdu &pdu)
{
    return pdu.functionCode() == QModbusPdu::WriteMultipleRegisters;
}

Shape answerShape(int address, const QModbusRequest &pdu)
{
    QByteArray head;
    appendByte(head, address);
    appendByte(head, pdu.functionCode());
    if (isWrite(pdu)) {
        head += pdu.data().left(4);
        return {head, head.size() + 2};
    }
    const int byteCount = 2 * readBig<quint16>(pdu.data(), 2).value_or(0);
    appendByte(head, byteCount);
    return {head, head.size() + byteCount + 2};
}

Shape exceptionShape(int address, const QModbusRequest &pdu)
{
    QByteArray head;
    appendByte(head, address);
    appendByte(head, pdu.functionCode() | QModbusPdu::ExceptionByte);
    return {head, exceptionLength};
}

bool hasGoodCrc(QByteArrayView frame)
{
    return readLittle<quint16>(frame, frame.size() - 2) == crc16Modbus(frame.chopped(2));
}

/// One of the two begins with the other: so far \a bytes may be \a expected.
bool agree(QByteArrayView bytes, QByteArrayView expected)
{
    const qsizetype common = std::min(bytes.size(), expected.size());
    return bytes.first(common) == expected.first(common);
}

/// What \a rest begins with; empty: with nothing that could be of this shape. The first of several possible beginnings
/// decides, so that it does not matter in which pieces the bytes arrive.
std::optional<Scan> look(QByteArrayView rest, const Shape &shape)
{
    if (!agree(rest, shape.head)) {
        return std::nullopt;
    }
    if (rest.size() < shape.length) {
        return Scan::incomplete();
    }
    // Noise that looks like a head must not swallow the frame that follows it: only its first byte is given up.
    return hasGoodCrc(rest.first(shape.length)) ? Scan::complete(0, shape.length) : Scan::damaged(0, 1);
}

Scan scanAnswer(QByteArrayView bytes, const QByteArray &request, const Shape &answer, const Shape &exception)
{
    qsizetype at = 0;
    while (at < bytes.size()) {
        const QByteArrayView rest = bytes.sliced(at);
        auto found = look(rest, answer);
        if (!found) {
            found = look(rest, exception);
        }
        if (found && found->state != Scan::State::Damaged) {
            return {found->state, at, found->length};
        }
        if (agree(rest, request)) { // the echo of a write begins like its answer
            if (rest.size() < request.size()) {
                return Scan::incomplete(at);
            }
            at += request.size();
        } else if (found) {
            return Scan::damaged(at, found->length);
        } else {
            ++at;
        }
    }
    return Scan::incomplete(bytes.size());
}

} // namespace

QModbusRequest readHoldingRegisters(quint16 first, int count)
{
    if (count < 1 || count > mostRegistersToRead) {
        return {};
    }
    return {QModbusPdu::ReadHoldingRegisters, first, static_cast<quint16>(count)};
}

QModbusRequest readInputRegisters(quint16 first, int count)
{
    if (count < 1 || count > mostRegistersToRead) {
        return {};
    }
    return {QModbusPdu::ReadInputRegisters, first, static_cast<quint16>(count)};
}

QModbusRequest writeRegisters(quint16 first, const QList<quint16> &values)
{
    if (values.isEmpty() || values.size() > mostRegistersToWrite) {
        return {};
    }
    const auto count = static_cast<quint16>(values.size());
    return {QModbusPdu::WriteMultipleRegisters, first, count, static_cast<quint8>(2 * count), values};
}

QByteArray frame(int address, const QModbusPdu &pdu)
{
    QByteArray bytes;
    appendByte(bytes, address);
    appendByte(bytes, pdu.isException() ? pdu.functionCode() | QModbusPdu::ExceptionByte : pdu.functionCode());
    bytes += pdu.data();
    appendLittle(bytes, crc16Modbus(bytes));
    return bytes;
}

Request request(int address, const QModbusRequest &pdu)
{
    const QByteArray bytes = frame(address, pdu);
    return {
        bytes,
        [bytes, answer = answerShape(address, pdu), exception = exceptionShape(address, pdu)](QByteArrayView received) {
            return scanAnswer(received, bytes, answer, exception);
        }};
}

Result<QModbusResponse> response(QByteArrayView frame)
{
    if (frame.size() < exceptionLength || !hasGoodCrc(frame)) {
        return Fault::BadReply;
    }
    const quint8 function = byteAt(frame, 1);
    if (function & QModbusPdu::ExceptionByte) {
        return Fault::Refused;
    }
    return QModbusResponse(
        static_cast<QModbusPdu::FunctionCode>(function), frame.sliced(2, frame.size() - envelope).toByteArray());
}

Result<QList<quint16>> registers(QByteArrayView frame)
{
    const auto answer = response(frame);
    if (!answer) {
        return answer.fault();
    }
    const QByteArray data = answer->data();
    const bool isRead = answer->functionCode() == QModbusPdu::ReadHoldingRegisters
        || answer->functionCode() == QModbusPdu::ReadInputRegisters;
    if (!isRead || data.size() % 2 == 0 || byteAt(data, 0) != data.size() - 1) {
        return Fault::BadReply;
    }
    QList<quint16> values;
    for (qsizetype at = 1; at < data.size(); at += 2) {
        values.append(readBig<quint16>(data, at).value_or(0));
    }
    return values;
}

Result<void> confirmation(QByteArrayView frame)
{
    const auto answer = response(frame);
    if (!answer) {
        return answer.fault();
    }
    return isWrite(*answer) && answer->data().size() == 4 ? Result<void>() : Result<void>(Fault::BadReply);
}

} // namespace gorizont::modbusrtu
