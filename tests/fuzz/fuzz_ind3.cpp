#include "core/devices/ind3/ind3protocol.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;
using namespace gorizont::ind3;

namespace {

constexpr Packet questions[] = {Packet::ReadAngles,   Packet::Version,   Packet::GetBaud,
                                Packet::GetName,      Packet::GetOffset, Packet::Revision,
                                Packet::SerialNumber, Packet::GetTicks,  Packet::GetPeriod};

void decodeEverything(const QByteArray &bytes)
{
    (void)decodeAngles(bytes);
    (void)decodeVersion(bytes);
    (void)decodeSelfTest(bytes);
    (void)decodeBaud(bytes);
    (void)decodeNameAnswer(bytes);
    (void)decodeOffset(bytes);
    (void)decodeRevision(bytes);
    (void)decodeSerialNumber(bytes);
    (void)decodeTicks(bytes);
    (void)decodePeriod(bytes);
}

} // namespace

/// Protocol 2.11: bytes from the line.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (const Packet packet : questions) {
        const auto answer = fuzz::sameAnswerInPieces(ask(packet, 1)->scan, bytes);
        if (answer) {
            const auto frame = decodeFrame(*answer);
            fuzz::require(frame && isAnswer(*frame, packet, 1), "what the scan finds is the answer");
            decodeEverything(*answer);
        }
    }
    fuzz::sameAnswerInPieces(setAddress(1, 2)->scan, bytes);
    decodeEverything(bytes);
    return 0;
}
