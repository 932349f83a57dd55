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

} // namespace

/// Any byte stream: the answers are whole frames, one for each request, and what remains is less than a frame.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const UnitImages images = makeImages();
    const QByteArrayView received(data, static_cast<qsizetype>(size));
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
    return 0;
}
