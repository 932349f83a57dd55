#include "core/devices/mk14/mk14parameters.h"
#include "core/devices/mk14/mk14values.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;
using namespace gorizont::ack;

namespace {

void answers(const QByteArray &bytes, const Question &question)
{
    const auto answer = fuzz::sameAnswerInPieces(ask(question, 0).scan, bytes);
    if (answer) {
        const auto decoded = decodeAnswer(*answer, question);
        fuzz::require(bool(decoded), "what the scan finds is an answer");
        Weather weather;
        mk14::put(weather, question.command, *decoded, mk14::usualParameters());
        fuzz::require(weather.parameters.size() == decoded->parameters.size(), "every parameter has a place");
    }
    (void)decodeAnswer(bytes, question);
}

} // namespace

/// МК-14 and АКП: bytes from the line, on both of its ends, and their file of parameters.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (int command = firstDataCommand; command <= lastDataCommand; ++command) {
        for (const int parameters : {0, 2, 6}) {
            for (const int address : {1, 2, 9, 255}) {
                answers(bytes, {static_cast<quint8>(address), static_cast<quint8>(command), parameters});
            }
        }
    }
    for (const int address : {1, 3}) {
        const auto station = static_cast<quint8>(address);
        const auto asked = fuzz::sameAnswerInPieces(
            [station](QByteArrayView received) { return scanRequest(received, station); }, bytes);
        fuzz::require(!asked || bool(decodeRequest(*asked)), "what the scan finds is a request");
        (void)fuzz::sameAnswerInPieces(askTime(station, 0).scan, bytes);
    }
    (void)decodeRequest(bytes);
    (void)mk14::parametersInFile(bytes);
    return 0;
}
