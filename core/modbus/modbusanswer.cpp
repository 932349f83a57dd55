#include "core/modbus/modbusanswer.h"

#include "core/protocol/bytes.h"
#include "core/protocol/mbap.h"

#include <QModbusPdu>

#include <cstring>

namespace gorizont {

namespace {

constexpr int registerLimit = 125;
constexpr qsizetype readRequestSize = 5; ///< function, address, quantity

/// Opens a frame whose PDU has \a pduSize bytes and returns where the PDU goes.
char *appendHeader(AnswerBuffer &answers, const MbapFrame &request, qsizetype pduSize)
{
    const qsizetype at = answers.size();
    answers.resize(at + mbap::headerSize + pduSize);
    char *frame = answers.data() + at;
    qToBigEndian(request.transaction, frame);
    qToBigEndian(request.protocol, frame + 2);
    qToBigEndian(static_cast<quint16>(1 + pduSize), frame + 4);
    frame[6] = static_cast<char>(request.unit);
    return frame + mbap::headerSize;
}

void appendException(AnswerBuffer &answers, const MbapFrame &request, QModbusPdu::ExceptionCode code)
{
    char *pdu = appendHeader(answers, request, 2);
    pdu[0] = static_cast<char>(byteAt(request.pdu, 0) | QModbusPdu::ExceptionByte);
    pdu[1] = static_cast<char>(code);
}

/// Returns where the registers are in the answer.
char *appendRegisters(AnswerBuffer &answers, const MbapFrame &request, QByteArrayView registers)
{
    char *pdu = appendHeader(answers, request, 2 + registers.size());
    pdu[0] = request.pdu.front();
    pdu[1] = static_cast<char>(registers.size());
    std::memcpy(pdu + 2, registers.data(), static_cast<std::size_t>(registers.size()));
    return pdu + 2;
}

bool isServed(const UnitLayout &layout, quint8 function)
{
    return function == QModbusPdu::ReadInputRegisters
        || (layout.isHolding && function == QModbusPdu::ReadHoldingRegisters);
}

/// Returns whether the answer carries registers, not an exception.
bool answer(const MbapFrame &request, const UnitImages &images, AnswerBuffer &answers)
{
    const UnitImage *image = images.unit(request.unit);
    if (image == nullptr) {
        appendException(answers, request, QModbusPdu::GatewayTargetDeviceFailedToRespond);
        return false;
    }
    if (!isServed(image->layout(), byteAt(request.pdu, 0))) {
        appendException(answers, request, QModbusPdu::IllegalFunction);
        return false;
    }
    const int address = readBig<quint16>(request.pdu, 1).value_or(0);
    const int quantity = readBig<quint16>(request.pdu, 3).value_or(0);
    if (request.pdu.size() != readRequestSize || quantity < 1 || quantity > registerLimit) {
        appendException(answers, request, QModbusPdu::IllegalDataValue);
        return false;
    }
    const std::optional<QByteArrayView> registers = image->block().registers(address, quantity);
    if (!registers) {
        appendException(answers, request, QModbusPdu::IllegalDataAddress);
        return false;
    }
    char *copied = appendRegisters(answers, request, *registers);
    if (image->hasClocks()) {
        image->writeClocks(copied, address, quantity, Moment::now());
    }
    return true;
}

} // namespace

AnsweredRequests answerRequests(QByteArrayView received, const UnitImages &images, AnswerBuffer &answers)
{
    AnsweredRequests done;
    for (;;) {
        const QByteArrayView rest = received.sliced(done.consumed);
        const Scan scan = scanMbap(rest);
        if (scan.state != Scan::State::Complete) {
            done.isBroken = scan.state == Scan::State::Damaged;
            return done;
        }
        ++done.requests;
        if (!answer(readMbap(rest.first(scan.length)), images, answers)) {
            ++done.exceptions;
        }
        done.consumed += scan.length;
    }
}

} // namespace gorizont
