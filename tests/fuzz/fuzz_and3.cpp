#include "core/devices/and3/and3answers.h"
#include "core/devices/and3/and3packet.h"
#include "core/devices/and3/and3protocol.h"
#include "core/devices/and3/and3ring.h"
#include "core/devices/and3/and3simulator.h"
#include "core/protocol/checksums.h"
#include "tests/fuzz/scancheck.h"

using namespace gorizont;
using namespace gorizont::and3;

namespace {

const Request questions[] = {
    Request::complexRead(1),
    Request::packets(1, 0, 1),
    Request::packets(1, 0, 4),
    Request::mode(1, ModeBit::RebootAcknowledged, true),
    Request::reset(1),
    Request::information(1, InformationKind::Firmware),
    Request::complexRead(12),
    Request::configuration(1, ConfigurationKind::Current),
    Request::writeConfiguration(1)};

void parseEverything(const QByteArray &answer)
{
    (void)parseComplexRead(answer);
    (void)parseInformation(answer);
    (void)parseFirmware(answer);
    (void)parseConfiguration(answer);
    if (const auto packets = parsePackets(answer); packets && packets->size() < ringCells / 2) {
        RingReader ring(1, -0.006);
        ring.observe(static_cast<quint32>(packets->size()) * packetSamples, false, UtcTime());
        const auto taken = ring.take(*packets);
        fuzz::require(taken.blocks.size() + taken.rejected == packets->size(), "every packet is taken or rejected");
        fuzz::require(ring.available() == 0, "what was taken is read");
    }
}

/// What is taken for an answer must be one, however the bytes arrive. Which of several frames it is may depend on that:
/// an inner frame is taken while the frame around it is not whole.
void checkAnswer(const Request &request, const std::optional<QByteArray> &answer)
{
    if (!answer) {
        return;
    }
    const QByteArray head = request.toBytes().left(headerSize);
    fuzz::require(answer->startsWith(head), "the answer is of the sensor and of the operation that were asked");
    const auto sum = crc16CcittFalse(QByteArrayView(*answer).chopped(sumSize));
    fuzz::require(static_cast<quint8>(answer->at(answer->size() - 2)) == (sum & 0xFF), "low byte of the check sum");
    fuzz::require(static_cast<quint8>(answer->back()) == (sum >> 8), "high byte of the check sum");
    parseEverything(*answer);
}

} // namespace

/// Bytes from the line, and the same as bytes from a host to the simulated sensor.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (const Request &request : questions) {
        checkAnswer(request, test::answerIn(fuzz::checked(answerTo(request)), bytes));
        checkAnswer(request, test::answerIn(fuzz::checked(answerTo(request)), bytes, 7));
    }
    parseEverything(bytes);
    And3Simulator simulator({}, 1);
    simulator.receive(bytes, std::chrono::hours(1));
    return 0;
}
