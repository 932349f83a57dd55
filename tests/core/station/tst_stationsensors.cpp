#include "core/station/gammasensor.h"
#include "core/station/precipitation.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace std::chrono_literals;

/// The gamma sensor gate by gate, and the rain.
class TestStationSensors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gates()
    {
        GammaConfig config;
        config.gate = 2s;
        GammaSensor sensor(config);
        QCOMPARE(sensor.step(10, 5min).frequency, std::nullopt);
        QCOMPARE(sensor.step(20, 5min).frequency, 15.0);
        QCOMPARE(sensor.step(1, 5min).frequency, 15.0);
        QCOMPARE(sensor.step(0, 5min).frequency, 0.5);
    }

    void check_data()
    {
        QTest::addColumn<int>("pulsesOpen");
        QTest::addColumn<bool>("isGood");
        QTest::newRow("more pulses") << 9 << true;
        QTest::newRow("as many") << 8 << false;
        QTest::newRow("none") << 0 << false;
    }

    /// The check begins with the first whole gate in its minute, lasts one gate, and does not touch the measured value.
    void check()
    {
        QFETCH(const int, pulsesOpen);
        GammaConfig config;
        config.gate = 2s;
        config.checkAt = 7min;
        GammaSensor sensor(config);
        sensor.step(4, 6min);
        QVERIFY(!sensor.step(4, 6min).isBlinkerOn);
        QVERIFY(!sensor.step(4, 7min).isBlinkerOn);
        const auto opened = sensor.step(4, 7min);
        QVERIFY(opened.isBlinkerOn);
        QCOMPARE(opened.check, std::nullopt);
        const auto during = sensor.step(pulsesOpen, 7min);
        QVERIFY(during.isBlinkerOn);
        QCOMPARE(during.frequency, 4.0);
        const auto done = sensor.step(0, 7min);
        QVERIFY(!done.isBlinkerOn);
        QCOMPARE(done.frequency, 4.0);
        QCOMPARE(done.check, (GammaSensor::Check{8, pulsesOpen}));
        QTEST(done.check->isGood(), "isGood");
        for (int i = 0; i < 10; ++i) {
            const auto after = sensor.step(1, 7min);
            QVERIFY(!after.isBlinkerOn);
            QVERIFY(!after.check);
        }
        sensor.step(1, 6min);
        sensor.step(1, 7min); // the next day
        QVERIFY(sensor.step(1, 8min).isBlinkerOn || sensor.step(1, 8min).isBlinkerOn);
    }

    /// A station that starts in the minute of the check leaves it for the next day.
    void noCheckAtTheStart()
    {
        GammaConfig config;
        config.checkAt = 7min;
        GammaSensor sensor(config);
        for (int i = 0; i < 60; ++i) {
            QVERIFY(!sensor.step(1, 7min).isBlinkerOn);
        }
    }

    void rain()
    {
        PrecipitationWatch watch;
        watch.update(false, 100);
        QVERIFY(watch.events().isEmpty());
        watch.update(true, 101);
        watch.update(true, 102);
        watch.update(false, 103);
        const QList<PrecipitationEvent> expected{{false, 103}, {true, 101}};
        QCOMPARE(watch.events(), expected);
    }

    void onlyTheTenNewest()
    {
        PrecipitationWatch watch;
        for (int i = 1; i <= 13; ++i) {
            watch.update(i % 2 != 0, i);
        }
        QCOMPARE(watch.events().size(), 10);
        QCOMPARE(watch.events().first(), (PrecipitationEvent{true, 13}));
        QCOMPARE(watch.events().last(), (PrecipitationEvent{false, 4}));
    }
};

QTEST_GUILESS_MAIN(TestStationSensors)
#include "tst_stationsensors.moc"
