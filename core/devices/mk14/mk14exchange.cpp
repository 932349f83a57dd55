#include "core/devices/mk14/mk14exchange.h"

namespace gorizont::mk14 {

namespace {

/// The longest answer to \a question that is to be expected.
qsizetype answerSize(const ack::Question &question)
{
    constexpr qsizetype valueSize = 4;
    const int extras = question.command == ack::lastDataCommand ? ack::extraFloats + ack::extraTimes : 0;
    const int values = question.parameters * ack::valuesPerParameter(question.command) + extras;
    return ack::headerSize + values * valueSize + 1;
}

} // namespace

std::chrono::milliseconds wireTime(const Line &line, qsizetype bytes)
{
    constexpr qint64 bitsPerByte = 11;
    const auto port = line.port();
    return port && port->baudRate > 0 ? std::chrono::milliseconds(bytes * bitsPerByte * 1000 / port->baudRate)
                                      : std::chrono::milliseconds(0);
}

Result<ack::Answer> ask(
    Line &line, const ack::Question &question, quint32 outputs, const Timing &timing,
    std::chrono::microseconds quietBefore)
{
    const Request request = ack::ask(question, outputs);
    const auto answer = line.exchange(
        {.request = request.bytes,
         .scan = request.scan,
         .writeTimeout = timing.writeCommand,
         .readTimeout = timing.readCommand + wireTime(line, request.bytes.size() + answerSize(question)),
         .quietBefore = quietBefore});
    return answer ? ack::decodeAnswer(*answer, question) : answer.fault();
}

} // namespace gorizont::mk14
