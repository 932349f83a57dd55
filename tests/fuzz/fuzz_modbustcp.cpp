#include "core/protocol/modbustcp.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;

/// Modbus TCP, the client's side: bytes from a device, to a question, to a setting and to both at once.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    using namespace modbustcp;

    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const QByteArray read = readRegisters(ReadFunction::HoldingRegisters, 1024, 30);
    const QByteArray write = writeRegisters(40960, {0x5649});
    const QByteArray both = writeAndReadRegisters(36864, 124, 36864, {0, 1, 0, 0});
    // The envelope of what the fuzzer sends, so that it gets behind the first check.
    const Envelope envelope{
        static_cast<quint16>(size > 1 ? data[0] << 8 | data[1] : 0), static_cast<quint8>(size > 6 ? data[6] : 1)};
    for (const QByteArray &pdu : {read, write, both}) {
        if (const auto answer = fuzz::sameAnswerInPieces(request(envelope, pdu).scan, bytes)) {
            const auto values = registers(*answer, 30);
            fuzz::require(!values || values->size() == 30, "as many registers as were asked for");
            fuzz::require(!(values && confirmation(*answer, pdu)), "an answer is values or a confirmation");
        }
    }
    (void)registers(bytes, 30);
    (void)confirmation(bytes, write);
    return 0;
}
