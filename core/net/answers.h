#pragma once

#include <QByteArrayView>
#include <QVarLengthArray>

#include <functional>

namespace gorizont {

/// Answers on their way to the socket; the usual few live on the stack.
using AnswerBuffer = QVarLengthArray<char, 2048>;

/// What became of a piece of a client's byte stream.
struct AnsweredRequests
{
    qsizetype consumed = 0; ///< bytes; the rest, shorter than a request, is the start of the next one
    quint64 requests = 0; ///< answered, exceptions included
    quint64 exceptions = 0; ///< answered with "cannot be done"
    quint64 unanswered = 0; ///< of the length of a request and none; the next one is found nevertheless
    bool isBroken = false; ///< there is no way to find the next request: the connection must be closed
};

/// Appends to \a answers one answer for each whole request in \a received, in their order.
using AnswerFunction = std::function<AnsweredRequests(QByteArrayView received, AnswerBuffer &answers)>;

} // namespace gorizont
