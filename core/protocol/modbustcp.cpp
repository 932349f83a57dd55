#include "core/protocol/modbustcp.h"

#include "core/protocol/bytes.h"
#include "core/protocol/mbap.h"

namespace gorizont::modbustcp {

namespace {

constexpr int writeFunction = 16;
constexpr int writeAndReadFunction = 23;
constexpr int exceptionBit = 0x80;
constexpr quint16 protocol = 0;
constexpr qsizetype shortestLength =
    3; ///< unit, function, and at least one byte: every answer has more than a function

bool isWithin(qsizetype count, int most)
{
    return count >= 1 && count <= most;
}

void appendValues(QByteArray &pdu, const QList<quint16> &values)
{
    appendBig(pdu, static_cast<quint16>(values.size()));
    appendByte(pdu, static_cast<int>(2 * values.size()));
    for (const quint16 value : values) {
        appendBig(pdu, value);
    }
}

QByteArray headOf(int function, quint16 first)
{
    QByteArray pdu;
    appendByte(pdu, function);
    appendBig(pdu, first);
    return pdu;
}

/// What the answer to a question begins with.
struct Expected
{
    QByteArray envelope; ///< transaction, protocol
    quint8 unit = 0;
    quint8 function = 0;

    bool agreesWith(QByteArrayView bytes) const
    {
        const qsizetype common = std::min(bytes.size(), envelope.size());
        if (bytes.first(common) != QByteArrayView(envelope).first(common)) {
            return false;
        }
        const auto length = readBig<quint16>(bytes, 4);
        if (length && (*length < shortestLength || *length > mbap::longest)) {
            return false;
        }
        const bool isOurs = bytes.size() <= mbap::lengthEnd || byteAt(bytes, mbap::lengthEnd) == unit;
        return isOurs
            && (bytes.size() <= mbap::headerSize || (byteAt(bytes, mbap::headerSize) & ~exceptionBit) == function);
    }
};

/// Its head is known whole, so that nothing else is taken for it; a longer one is searched for from the next byte on.
Scan scanAnswer(QByteArrayView bytes, const Expected &expected)
{
    for (qsizetype at = 0; at < bytes.size(); ++at) {
        const QByteArrayView rest = bytes.sliced(at);
        if (expected.agreesWith(rest)) {
            const Scan found = scanMbap(rest);
            return {found.state, at, found.length};
        }
    }
    return Scan::incomplete(bytes.size());
}

/// Function and data of a whole frame; empty: it is none.
QByteArrayView pduOf(QByteArrayView frame)
{
    const Scan scan = scanMbap(frame);
    const bool isWhole = scan.state == Scan::State::Complete && scan.length == frame.size();
    return isWhole ? readMbap(frame).pdu : QByteArrayView();
}

} // namespace

QByteArray readRegisters(ReadFunction function, quint16 first, int count)
{
    if (!isWithin(count, mostRegistersToRead)) {
        return {};
    }
    QByteArray pdu = headOf(static_cast<int>(function), first);
    appendBig(pdu, static_cast<quint16>(count));
    return pdu;
}

QByteArray writeRegisters(quint16 first, const QList<quint16> &values)
{
    if (!isWithin(values.size(), mostRegistersToWrite)) {
        return {};
    }
    QByteArray pdu = headOf(writeFunction, first);
    appendValues(pdu, values);
    return pdu;
}

QByteArray writeAndReadRegisters(quint16 readFirst, int readCount, quint16 writeFirst, const QList<quint16> &values)
{
    if (!isWithin(readCount, mostRegistersToRead) || !isWithin(values.size(), mostRegistersToWriteAndRead)) {
        return {};
    }
    QByteArray pdu = headOf(writeAndReadFunction, readFirst);
    appendBig(pdu, static_cast<quint16>(readCount));
    appendBig(pdu, writeFirst);
    appendValues(pdu, values);
    return pdu;
}

Request request(const Envelope &envelope, const QByteArray &pdu)
{
    QByteArray head;
    appendBig(head, envelope.transaction);
    appendBig(head, protocol);
    const Expected expected{head, envelope.unit, byteAt(pdu, 0)};
    QByteArray bytes = head;
    appendBig(bytes, static_cast<quint16>(pdu.size() + 1));
    appendByte(bytes, envelope.unit);
    bytes += pdu;
    return {bytes, [expected](QByteArrayView received) { return scanAnswer(received, expected); }};
}

Result<QList<quint16>> registers(QByteArrayView frame, int count)
{
    if (exceptionCode(frame)) {
        return Fault::Refused;
    }
    const QByteArrayView pdu = pduOf(frame);
    const qsizetype size = 2 * static_cast<qsizetype>(count);
    if (pdu.size() != size + 2 || byteAt(pdu, 1) != size || byteAt(pdu, 0) == writeFunction) {
        return Fault::BadReply;
    }
    QList<quint16> values;
    values.reserve(count);
    for (qsizetype at = 2; at < pdu.size(); at += 2) {
        values.append(readBig<quint16>(pdu, at).value_or(0));
    }
    return values;
}

Result<void> confirmation(QByteArrayView frame, QByteArrayView pdu)
{
    if (exceptionCode(frame)) {
        return Fault::Refused;
    }
    constexpr qsizetype echoed = 5; // function, first, count
    return pdu.size() > echoed && byteAt(pdu, 0) == writeFunction && pduOf(frame) == pdu.first(echoed)
        ? Result<void>()
        : Fault::BadReply;
}

std::optional<quint8> exceptionCode(QByteArrayView frame)
{
    const QByteArrayView pdu = pduOf(frame);
    const bool isException = pdu.size() == 2 && (byteAt(pdu, 0) & exceptionBit);
    return isException ? std::optional(byteAt(pdu, 1)) : std::nullopt;
}

} // namespace gorizont::modbustcp
