#include "core/devices/ind3/ind3modbus.h"
#include "core/protocol/modbusrtu.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;

/// Modbus RTU: bytes from the line, to questions and to a setting.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    using namespace ind3::modbus;

    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (const auto &question : {readAngles(1), readSettings(1), readOffsets(1), setOffset(1, {}), setAddress(1, 2)}) {
        const auto answer = fuzz::sameAnswerInPieces(question->scan, bytes);
        if (answer) {
            const auto response = modbusrtu::response(*answer);
            fuzz::require(response || response.fault() == Fault::Refused, "what the scan finds is an answer");
        }
    }
    (void)modbusrtu::registers(bytes);
    (void)modbusrtu::confirmation(bytes);
    (void)decodeAngles(bytes);
    (void)decodeSettings(bytes);
    (void)decodeOffsets(bytes);
    return 0;
}
