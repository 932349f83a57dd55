#pragma once

#include "core/devices/and3/and3driver.h"
#include "tests/core/devices/and3frames.h"
#include "tests/support/fakeline.h"

/// What the tests of the АН-Д3 driver share.
namespace gorizont::test {

inline const QByteArray askComplex = hex("01 C9 00 00 12 4A");
inline const QByteArray askFirstPacket = hex("01 CB 00 01 53 34");
inline const QByteArray acknowledge = hex("01 32 65 01 4F BD");
inline const QByteArray done50 = hex("01 32 2F 38");

constexpr quint16 healthy = 0x240F;
constexpr quint16 rebooted = 0x240E;

inline DriverSettings settingsOfTest()
{
    DriverSettings settings;
    settings.sensor.number = 3;
    settings.sensor.address = 1;
    settings.sensor.isOn = true;
    settings.sensor.measuresTilt = true;
    settings.sensor.measuresTemperature = true;
    settings.sensor.measuresAcceleration = true;
    return settings;
}

inline QByteArray askPackets(int cell, int count)
{
    return sealed({1, 203, cell, count});
}

inline QStringList texts(Driver &driver)
{
    QStringList list;
    for (const DriverNote &note : driver.takeNotes()) {
        list.append(note.text);
    }
    return list;
}

/// A driver on a line that plays a script, and a clock of the test.
struct DriverBench
{
    explicit DriverBench(const DriverSettings &settings = settingsOfTest())
        : driver(settings, [this] { return now; })
    {
    }

    /// One poll that is answered with a count of \a samples.
    Result<Measurement> pollAt(quint32 samples, quint16 status = healthy)
    {
        line.expect(askComplex, complexReadAnswer(samples, status));
        if (!(status & 1)) {
            line.expect(acknowledge, done50);
        }
        return driver.poll(line);
    }

    Result<QList<SampleBlock>> fetch(quint64 first, int count)
    {
        line.expect(askPackets(static_cast<int>(first % 128), count), packetsAnswer(first, count));
        return driver.fetch(line);
    }

    bool isClean() const { return line.isDone() && line.complaints().isEmpty(); }

    UtcTime now{std::chrono::seconds(1'700'000'000)};
    and3::And3Driver driver;
    FakeLine line;
};

} // namespace gorizont::test
