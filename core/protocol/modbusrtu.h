#pragma once

#include "core/protocol/request.h"
#include "core/values/result.h"

#include <QList>
#include <QModbusPdu>

/// Modbus RTU around Qt's own PDU types: "MODBUS over serial line", version 1.02, section 2.5.1; "MODBUS application
/// protocol", version 1.1b3, sections 6.3, 6.4, 6.12 and 7.
///
///     AA FF data… CL CH
///
///     AA     address 1…247 by the standard; 1…255 here, because the sensors allow it
///     FF     function 03, 04 or 16 (hexadecimal 10); an exception answers with bit 7 set and one byte of code
///     data   big-endian: request  03, 04: first register, count · 16: first, count, 2 × count, values
///                        answer   03, 04: 2 × count, values     · 16: first, count
///     CL CH  CRC-16/MODBUS of everything before, low byte first
///
/// Between frames the line is silent for at least 3.5 characters: Exchange::quietBefore, see frameSilence.
namespace gorizont::modbusrtu {

/// 3.5 characters of 11 bits last 4.01 ms at 9600 baud, 10 bits of 8N1 3.65 ms; above 19200 baud the standard fixes
/// 1.75 ms. A driver does not know the speed of its line, so it keeps what the usual slow one needs; that costs a fast
/// line next to nothing.
constexpr std::chrono::microseconds frameSilence = std::chrono::milliseconds(4);

constexpr int mostRegistersToRead = 125;
constexpr int mostRegistersToWrite = 123;

/// Functions 03, 04 and 16. Not isValid() when the number of registers is outside the standard.
QModbusRequest readHoldingRegisters(quint16 first, int count);
QModbusRequest readInputRegisters(quint16 first, int count);
QModbusRequest writeRegisters(quint16 first, const QList<quint16> &values);

/// Any PDU in its envelope.
QByteArray frame(int address, const QModbusPdu &pdu);

/// \a pdu: one of the above, valid. The scan finds its answer or an exception to it, and passes over an echo.
Request request(int address, const QModbusRequest &pdu);

/// The PDU of an answer that the scan found. Refused: it is an exception.
Result<QModbusResponse> response(QByteArrayView frame);

/// The registers in an answer to function 03 or 04. Refused: an exception; BadReply: not such an answer.
Result<QList<quint16>> registers(QByteArrayView frame);

/// Whether an answer confirms function 16. Refused: an exception; BadReply: not such an answer.
Result<void> confirmation(QByteArrayView frame);

/// Two registers, high word first. Both must exist.
inline quint32 doubleWord(const QList<quint16> &registers, qsizetype at)
{
    return static_cast<quint32>(registers.at(at)) << 16 | registers.at(at + 1);
}

} // namespace gorizont::modbusrtu
