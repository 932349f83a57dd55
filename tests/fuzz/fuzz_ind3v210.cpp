#include "core/devices/ind3/ind3protocol210.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;
using namespace gorizont::ind3;

/// Protocol 2.10: bytes from the line.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (const int address : {1, 0x35, 0xC8}) { // the latter two put the answer to a ping into its echo
        const auto angles = fuzz::sameAnswerInPieces(v210::readAngles(address)->scan, bytes);
        fuzz::require(!angles || v210::decodeAngles(*angles), "what the scan finds is the answer");
        const auto ping = fuzz::sameAnswerInPieces(v210::ping(address)->scan, bytes);
        fuzz::require(!ping || *ping == QByteArray("\x35"), "what the scan finds is the answer");
    }
    (void)v210::decodeAngles(bytes);
    return 0;
}
