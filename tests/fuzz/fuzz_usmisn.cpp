#include "core/devices/usmisn/usmisnprotocol.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;
using namespace gorizont::usmisn;

namespace {

void decodeEverything(const QByteArray &bytes, const Question &question)
{
    (void)decodeSerial(bytes, question);
    (void)decodeType(bytes, question);
    (void)decodeProgVersion(bytes, question);
    (void)decodeDateCalibration(bytes, question);
    (void)decodeCountCalibration(bytes, question);
    (void)decodeInfo(bytes, question);
    (void)decodeAddress(bytes, question);
    (void)decodeValue(bytes, question);
    (void)decodeRecord(bytes, question);
    (void)decodeCrc(bytes, question);
    (void)decodeEcho(bytes, {question, "19200,N,1"});
}

} // namespace

/// The УСМ series: bytes from the line.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (int i = 0; i <= static_cast<int>(Instruction::GetCrc); ++i) {
        for (const int address : {0, 123}) {
            const Question question{address, "001", static_cast<Instruction>(i)};
            const auto answer = fuzz::sameAnswerInPieces(
                [&question](QByteArrayView received) { return scanAnswer(received, question); }, bytes);
            if (answer) {
                fuzz::require(decodeAnswer(*answer, question).has_value(), "what the scan finds is the answer");
                decodeEverything(*answer, question);
            }
            decodeEverything(bytes, question);
        }
    }
    return 0;
}
