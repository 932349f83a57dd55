#pragma once

#include "core/protocol/request.h"
#include "core/values/result.h"

#include <QList>

/// The client's side of Modbus TCP: "MODBUS application protocol", version 1.1b3, sections 6.3, 6.4, 6.12, 6.17 and 7, in the
/// envelope of core/protocol/mbap. Qt's own types hold at most 123 registers for function 23; a device may need 124.
///
///     function   request                                            answer
///     03, 04     first, count                                       2 × count (one byte), values
///     16         first, count, 2 × count (one byte), values         first, count
///     23         first, count to read, first, count to write,       2 × count (one byte), values read
///                2 × count (one byte), values to write; the write comes before the read
namespace gorizont::modbustcp {

constexpr int mostRegistersToRead = 125; ///< 03, 04 and the read of 23
constexpr int mostRegistersToWrite = 123; ///< 16
constexpr int mostRegistersToWriteAndRead = 121; ///< the write of 23

enum class ReadFunction : quint8 { HoldingRegisters = 3, InputRegisters = 4 };

/// Who is asked, and which question it is: what its answer repeats.
struct Envelope
{
    quint16 transaction = 0;
    quint8 unit = 1;
};

/// Empty when a count is outside the standard.
QByteArray readRegisters(ReadFunction function, quint16 first, int count);
QByteArray writeRegisters(quint16 first, const QList<quint16> &values);
QByteArray writeAndReadRegisters(quint16 readFirst, int readCount, quint16 writeFirst, const QList<quint16> &values);

/// \a pdu: one of the above, not empty. The scan finds the answer to it or an exception, and passes over whatever else comes:
/// the late answer to another transaction, or what is left of one.
Request request(const Envelope &envelope, const QByteArray &pdu);

/// The \a count registers in the answer to function 03, 04 or 23 that the scan found. Refused: an exception; BadReply: not such
/// an answer.
Result<QList<quint16>> registers(QByteArrayView frame, int count);

/// Whether the answer that the scan found confirms function 16 as \a pdu asked for it. Refused: an exception; BadReply: it
/// confirms something else.
Result<void> confirmation(QByteArrayView frame, QByteArrayView pdu);

/// The code of an exception, 1…255 by the standard; empty: the frame is none.
std::optional<quint8> exceptionCode(QByteArrayView frame);

} // namespace gorizont::modbustcp
