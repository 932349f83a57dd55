#pragma once

#include "core/modbus/unitimages.h"

#include <QVarLengthArray>

namespace gorizont {

/// Answers on their way to the socket; the usual few live on the stack.
using AnswerBuffer = QVarLengthArray<char, 2048>;

/// What became of a piece of a client's byte stream.
struct AnsweredRequests
{
    qsizetype consumed = 0; ///< bytes; the rest, shorter than a frame, is the start of the next request
    quint64 requests = 0; ///< answered, exceptions included
    quint64 exceptions = 0;
    bool isBroken = false; ///< a length outside 2…254: the connection must be closed
};

/// Appends to \a answers one answer for each whole request in \a received, in their order. Pure but for the
/// clocks of unit 1, which show the moment of the answer.
/// Checked in this order (Modbus Application Protocol 1.1b3, section 6.4; spec/gorizont.md, section 6): the unit is
/// known (exception 0B), the function is 04, in unit 1 also 03 (01), the request is 5 bytes long and asks for 1…125 registers (03), all of
/// them exist (02).
AnsweredRequests answerRequests(QByteArrayView received, const UnitImages &images, AnswerBuffer &answers);

} // namespace gorizont
