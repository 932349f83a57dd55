#include "core/modbus/modbusanswer.h"
#include "core/protocol/mbap.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

using namespace gorizont;

namespace {

UnitImages makeImages()
{
    SensorConfig sensor;
    sensor.number = 1;
    sensor.isOn = true;
    sensor.measuresTilt = true;
    sensor.measuresAcceleration = true;
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    line.sensors = {sensor};
    ModbusConfig config;
    config.lines = {line};
    return UnitImages(config);
}

void require(bool holds)
{
    if (!holds) {
        std::abort();
    }
}

/// The answers are whole frames, one for each request, and what remains is less than a frame.
void checkAnswers(QByteArrayView received)
{
    static const UnitImages images = makeImages();
    AnswerBuffer answers;
    const AnsweredRequests done = answerRequests(received, images, answers);
    require(done.consumed >= 0 && done.consumed <= received.size() && done.exceptions <= done.requests);
    require(done.isBroken || received.size() - done.consumed < mbap::frameLimit);
    QByteArrayView rest(answers.constData(), answers.size());
    quint64 frames = 0;
    for (; !rest.isEmpty(); ++frames) {
        const Scan scan = scanMbap(rest);
        require(scan.state == Scan::State::Complete);
        rest = rest.sliced(scan.length);
    }
    require(frames == done.requests);
}

} // namespace

/// Any byte stream, and the same bytes as addresses and quantities of reads of unit 1, whose answers are written twice.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    checkAnswers(QByteArrayView(data, static_cast<qsizetype>(size)));
    QByteArray reads;
    for (size_t at = 0; at + 3 <= size && at < 300; at += 3) {
        reads += QByteArray::fromHex("0001000000060103");
        reads.append(static_cast<char>(data[at] % 16)); // below register 4096: head, directory, block and beyond
        reads.append(static_cast<char>(data[at + 1]));
        reads.append('\0');
        reads.append(static_cast<char>(data[at + 2]));
    }
    checkAnswers(reads);
    return 0;
}
