#pragma once

#include "core/modbus/modbusanswer.h"
#include "core/modbus/unitimages.h"
#include "tests/core/modbus/modbussite.h"
#include "tests/support/fakeline.h"

namespace gorizont::test {

using namespace std::chrono_literals;

/// An answer of N=2 (АН-Д3, port 1, address 1), with numbers whose floats are easy to work out by hand.
inline Reading answer()
{
    Reading reading;
    reading.number = 2;
    reading.isAnswer = true;
    reading.time = UtcTime(1517999583456789us); // 2018-02-07 10:33:03.456789 UTC
    reading.answeredAt = SteadyTime::clock::now();
    reading.status = 0x0018;
    reading.tilt = Tilt{-3600.0, 1800.5};
    reading.temperature = 21.375;
    reading.heaterPower = 99.5;
    reading.fanFrequency = 12.25;
    AccelStatistics statistics;
    statistics.maximum = 7.75;
    statistics.direction = 270.0;
    statistics.maximumX = -0.0;
    statistics.maximumY = -7.75;
    statistics.rms = 2.5;
    statistics.rmsX = 0.5;
    statistics.rmsY = 0.1;
    reading.acceleration = statistics;
    reading.rawStatus = 0x240F;
    reading.rawMode = 0xCC00;
    reading.ring = RingProgress{5728, 179};
    reading.counters = {70000, 3, 4294967301U};
    reading.period = 1000ms;
    reading.exchange = 31250us;
    return reading;
}

inline UnitImages answered()
{
    UnitImages images(modbusSite());
    images.update(answer());
    return images;
}

/// What a client gets for \a request, written in hex.
inline QByteArray ask(const UnitImages &images, const char *request)
{
    AnswerBuffer answers;
    answerRequests(hex(request), images, answers);
    return {answers.constData(), answers.size()};
}

} // namespace gorizont::test
