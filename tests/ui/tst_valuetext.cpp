#include "ui/models/valuetext.h"

#include "tests/ui/samplesite.h"

#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

/// The samples of spec/gorizont.md, sections 3 and 8, letter for letter.
class TestValueText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("TZ", "UTC"); }

    void tilt()
    {
        QCOMPARE(valuetext::tilt(Tilt{-3599.5, 2720.5}), QStringLiteral("-1.000 +0.756 (-3599.5 +2720.5)"));
        QCOMPARE(valuetext::tilt(std::nullopt), QStringLiteral("—"));
    }

    void degrees()
    {
        QCOMPARE(valuetext::degrees(2720.5), QStringLiteral("+0.756"));
        QCOMPARE(valuetext::degrees(0), QStringLiteral("+0.000"));
        QCOMPARE(valuetext::degreesAndArcSeconds(100), QStringLiteral("+0.028 (+100.0)"));
    }

    void acceleration()
    {
        const AccelStatistics statistics{7.67, 0, -7.67, 270, 2.19, 0, 2.19};
        QCOMPARE(
            valuetext::acceleration(statistics, RingProgress{179, 179}, 179),
            QStringLiteral("7.67 270.0 (2.19|0.00 2.19) 179:179 (5728) 179"));
        QCOMPARE(valuetext::acceleration(std::nullopt, RingProgress{10, 4}, 0), QStringLiteral("— 10:4 (128) 0"));
        QCOMPARE(valuetext::acceleration(std::nullopt, std::nullopt, 0), QStringLiteral("—"));
    }

    void poll()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        Reading reading = test::sampleReading(now);
        QCOMPARE(valuetext::poll(reading, now), QStringLiteral("1.002|0.031|00:00"));
        QCOMPARE(valuetext::poll(reading, now + 75s), QStringLiteral("1.002|0.031|01:15"));
        reading.period = 0us;
        QCOMPARE(valuetext::poll(reading, now + 3661s), QStringLiteral("—|0.031|1:01:01"));
        QCOMPARE(valuetext::poll(Reading(), now), QStringLiteral("—"));
    }

    void duration()
    {
        QCOMPARE(valuetext::duration(238900ms), QStringLiteral("0:03:58"));
        QCOMPARE(valuetext::duration(100h + 59s), QStringLiteral("100:00:59"));
        QCOMPARE(valuetext::duration(-1ms), QStringLiteral("0:00:00"));
        QCOMPARE(valuetext::age(3599s), QStringLiteral("59:59"));
    }

    void words()
    {
        QCOMPARE(valuetext::words(0x240F, 0xCC00), QStringLiteral("0010 0100 0000 1111 : 1100 1100 0000 0000"));
        QCOMPARE(valuetext::words(std::nullopt, std::nullopt), QStringLiteral("—"));
    }

    void status()
    {
        QCOMPARE(valuetext::status(0xA014), QStringLiteral("10 0000 0001 0100"));
        QCOMPARE(valuetext::status(0x0F00), QStringLiteral(" 0 1111 0000 0000"));
        QCOMPARE(valuetext::status(0x1700), QStringLiteral(" 1 0111 0000 0000"));
    }

    void clock()
    {
        // 1518028383 = date -u -d '2018-02-07 18:33:03' +%s
        QCOMPARE(valuetext::clock(UtcTime(1518028383s)), QStringLiteral("18:33:03 07.02.18"));
    }

    void invalidValuesAreAbsent()
    {
        Reading reading = test::sampleReading(std::chrono::steady_clock::now());
        QVERIFY(validTilt(reading) && validTemperature(reading) && validAcceleration(reading));
        reading.status = statusbit::TiltInvalid;
        QVERIFY(!validTilt(reading) && validTemperature(reading) && validAcceleration(reading));
        reading.status = statusbit::TemperatureInvalid | statusbit::AccelerationInvalid;
        QVERIFY(validTilt(reading) && !validTemperature(reading) && !validAcceleration(reading));
        QVERIFY(validHeaterPower({}, reading) && validFanFrequency({}, reading));
        reading.status = 0x3700;
        QVERIFY(!validTilt(reading) && !validHeaterPower({}, reading) && !validFanFrequency({}, reading));
    }

    /// A zero of a sensor without a thermostat is no measurement; one of a sensor with it is.
    void zeroOfNoThermostatIsAbsent()
    {
        SensorConfig sensor;
        Reading reading = test::sampleReading(std::chrono::steady_clock::now());
        reading.heaterPower = 0;
        reading.fanFrequency = 0;
        QVERIFY(!validHeaterPower(sensor, reading) && !validFanFrequency(sensor, reading));
        sensor.hasThermostat = true;
        QCOMPARE(validHeaterPower(sensor, reading), std::optional<double>(0));
        QCOMPARE(validFanFrequency(sensor, reading), std::optional<double>(0));
    }
};

QTEST_GUILESS_MAIN(TestValueText)
#include "tst_valuetext.moc"
