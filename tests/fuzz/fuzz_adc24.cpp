#include "core/adc24/adc24answer.h"
#include "core/protocol/bytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

using namespace gorizont;

namespace {

Adc24Image makeImage()
{
    Adc24Config config;
    config.number = 1;
    SampleBlock block;
    block.number = 1;
    for (int i = 0; i < 20000; ++i) {
        block.x.append(static_cast<qint16>(i));
    }
    block.y = block.x;
    Adc24Image image(config);
    image.append(block);
    return image;
}

void require(bool holds)
{
    if (!holds) {
        std::abort();
    }
}

/// The length of the answer at the start of \a answers, found as a client finds it.
qsizetype lengthOf(QByteArrayView answers, bool hasSamples)
{
    const bool isCount = answers.size() >= 6 && answers[1] == 1;
    const quint32 samples = readLittle<quint32>(answers, 4).value_or(0);
    return isCount ? 6 : hasSamples ? adc24::headerSize + 2 * qsizetype{samples} : 8;
}

/// Each 13 bytes are one request with one answer of the right length, or none.
void check(QByteArrayView received)
{
    static const Adc24Image image = makeImage();
    qsizetype at = 0;
    AnswerBuffer all;
    const AnsweredRequests done = answerAdc24(received, image, all);
    require(!done.isBroken && done.exceptions == 0);
    require(done.consumed % adc24::requestSize == 0 && received.size() - done.consumed < adc24::requestSize);
    require(static_cast<quint64>(done.consumed / adc24::requestSize) == done.requests + done.unanswered);
    for (qsizetype i = 0; i < done.consumed; i += adc24::requestSize) {
        const QByteArrayView request = received.sliced(i, adc24::requestSize);
        if (request[0] != 1 || (request[1] != 1 && request[1] != 3)) {
            continue;
        }
        const quint64 block = readLittle<quint32>(request, 5).value_or(0);
        const quint64 count =
            std::min<quint64>(std::max<quint64>(readLittle<quint32>(request, 9).value_or(0), 1), 8192);
        const QByteArrayView rest = QByteArrayView(all.constData(), all.size()).sliced(at);
        const qsizetype length = lengthOf(rest, (block + 1) * count <= 20000);
        require(length <= rest.size() && rest[1] == request[1]);
        at += length;
    }
    require(at == all.size());
}

} // namespace

/// Any byte stream; and the same with an address and a command that are known in every request, which chance rarely
/// gives.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const QByteArrayView received(data, static_cast<qsizetype>(size));
    check(received);
    QByteArray requests = received.toByteArray();
    for (qsizetype i = 0; i + 1 < requests.size(); i += adc24::requestSize) {
        requests[i] = 1;
        requests[i + 1] = (requests.at(i + 1) & 1) != 0 ? 1 : 3;
    }
    check(requests);
    return 0;
}
