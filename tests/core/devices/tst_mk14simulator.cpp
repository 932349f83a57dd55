#include "core/devices/drivercatalog.h"
#include "core/devices/mk14/mk14driver.h"
#include "tests/core/devices/mk14station.h"
#include "tests/support/fakeline.h"
#include "tests/support/simulatedtime.h"

#include <QTest>

#include <bit>

using namespace gorizont;
using namespace gorizont::mk14;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

Service service()
{
    return Service(Options::from(weatherStation()), {}, [] { return UtcTime(1'800'000'000s); });
}

DriverSettings settingsFor(const SensorConfig &sensor)
{
    DriverSettings settings;
    settings.sensor = sensor;
    return settings;
}

double mean(const Result<Weather> &weather, QChar code)
{
    const WeatherParameter *parameter = weather ? weather->find(code) : nullptr;
    return parameter ? parameter->mean.value_or(qQNaN()) : qQNaN();
}

} // namespace

/// Driver and service against the station that is simulated; the two were written apart.
class TstMk14Simulator : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresWhatMayBe()
    {
        StationLine line;
        line.advance(300s);
        for (int command = 1; command <= 8; ++command) {
            const auto weather = service().read(line, 1, command);
            QVERIFY2(weather, qPrintable(QString::number(command)));
            QCOMPARE(weather->parameters.size(), 6);
            QVERIFY(qAbs(mean(weather, u'U') - 12.4) < 0.2);
            QVERIFY(qAbs(mean(weather, u'P') - 748.5) < 4);
            QVERIFY(mean(weather, u'A') >= 0 && mean(weather, u'A') < 360);
            QVERIFY(mean(weather, u'M') > 0 && mean(weather, u'M') < 20);
            QVERIFY(mean(weather, u'H') > 0 && mean(weather, u'H') <= 100);
            const WeatherParameter &speed = weather->parameters.last();
            QCOMPARE(speed.instant.has_value(), command == 2 || (command >= 4 && command <= 6));
            QCOMPARE(speed.minimum.has_value(), command >= 3 && command <= 6);
            QCOMPARE(speed.voltage.has_value(), command == 5 || command == 6);
            QCOMPARE(speed.voltageInstant.has_value(), command == 6);
            QCOMPARE(speed.maxPeriod.has_value(), command >= 7);
            QVERIFY(!speed.minimum || *speed.minimum <= *speed.maximum);
        }
    }

    void theDriverHasAllOfItInTwoTurns()
    {
        StationLine line;
        line.advance(300s);
        const auto driver = mk14::makeDriver(settingsFor(weatherStation()));
        QVERIFY(driver->poll(line));
        line.advance(1s);
        const auto second = driver->poll(line);
        QVERIFY(second);
        const WeatherParameter *speed = second->weather->find(weathercode::windSpeed);
        QVERIFY(speed->mean && speed->instant && speed->minimum && speed->maximum && speed->maxPeriod);
        QVERIFY(speed->deviation && second->weather->find(weathercode::windDirection)->deviation);
        QCOMPARE(second->weather->events, QList<PrecipitationEvent>({{true, startOfClock + 240}}));
        QCOMPARE(second->weather->digital, 3U);
        QVERIFY(driver->takeNotes().isEmpty());
    }

    void showersComeNewestFirst()
    {
        StationLine line;
        line.advance(600s * 20 + 300s);
        const auto weather = service().read(line, 1, 8);
        QVERIFY(weather);
        QCOMPARE(weather->events.size(), 10);
        QCOMPARE(weather->events.at(0), (PrecipitationEvent{true, startOfClock + 12240}));
        QCOMPARE(weather->events.at(1), (PrecipitationEvent{false, startOfClock + 11820}));
    }

    void outputsClockAndFiles()
    {
        StationLine line;
        const auto set = service().setOutputs(line, 1, 0x00010005);
        QVERIFY(set);
        QCOMPARE(line.station().outputs(), 0x00010005U);
        QCOMPARE(set->digital, 0x00050001U);
        QVERIFY(service().setTime(line, 1));
        line.advance(10s);
        const qint64 shift = QDateTime::fromSecsSinceEpoch(1'800'000'000).offsetFromUtc();
        QCOMPARE(line.station().clock(line.elapsed()), 1'800'000'010 + shift);
        QVERIFY(service().sendFile(line, 1, "ACK.INI", "\xBB\xBB"));
        QCOMPARE(line.station().files().value("ACK.INI"), "\xBB\xBB");
        const auto driver = mk14::makeDriver(settingsFor(weatherStation()));
        QVERIFY(driver->poll(line));
        QCOMPARE(line.station().outputs(), 0x00010005U);
    }

    void faults()
    {
        StationLine line;
        const auto driver = mk14::makeDriver(settingsFor(weatherStation()));
        line.station().setSupplyBad(true);
        const auto bad = driver->poll(line);
        QVERIFY(bad);
        QVERIFY(bad->conditions.testFlag(Condition::TransducerSilent));
        line.station().setSupplyBad(false);
        line.station().setHasData(false);
        const auto empty = driver->poll(line);
        QVERIFY(empty && empty->weather->parameters.isEmpty() && !empty->conditions);
        line.station().setHasData(true);
        line.station().setValue(u'T', std::bit_cast<float>(0xBBBBBBBBU));
        for (int i = 0; i < 2; ++i) {
            const auto good = driver->poll(line);
            QVERIFY(good);
            QCOMPARE(good->temperature, double{std::bit_cast<float>(0xBBBBBBBBU)});
        }
        line.station().reboot(line.elapsed());
        QCOMPARE(driver->poll(line)->weather->parameters.size(), 0);
        line.advance(Simulator::startTime);
        QCOMPARE(driver->poll(line)->weather->parameters.size(), 6);
    }

    void hearsOnlyItself()
    {
        Simulator station(weatherStation(), 3, startOfClock);
        QVERIFY(station.receive(hex("BB 02 01 00 00 00 00 00 42"), 0s).isEmpty());
        QVERIFY(station.receive(hex("BB 01 01 00 00 00 00 00 44"), 0s).isEmpty());
        // A file for station 2 whose text holds a request to station 1.
        const QByteArray toAnother = hex("BB 02 FF 01 09 00 00 00 3A  41  BB 01 01 00 00 00 00 00 43  BF");
        QVERIFY(station.receive(toAnother, 0s).isEmpty());
        QVERIFY(!station.receive(hex("BB 00 BB 01 01 00 00 00 00 00 43"), 0s).isEmpty());
        // What was begun and not ended is forgotten.
        QVERIFY(station.receive(hex("BB 01 FF 07 07 00 00 00 37"), 1s).isEmpty());
        QVERIFY(!station.receive(hex("BB 01 01 00 00 00 00 00 43"), 3s).isEmpty());
    }

    void aDisturbedLine()
    {
        SimulatedBus::Options options;
        for (const char *fault : {"crc=20", "garbage=20", "pieces=30", "late=10"}) {
            options.faults.append(*parseSimulatedFault(QLatin1String(fault)));
        }
        LineConfig config;
        config.index = 1;
        config.baudRate = 9600;
        config.sensors = {weatherStation()};
        SimulatedTimeLine line(config, options);
        const auto driver = gorizont::makeDriver(settingsFor(weatherStation()));
        int good = 0;
        constexpr int turns = 300;
        for (int i = 0; i < turns; ++i) {
            line.wait(800ms);
            const auto measurement = driver->poll(line);
            good += bool(measurement);
            if (measurement) {
                const double supply = measurement->weather->find(weathercode::supply)->mean.value_or(0);
                QVERIFY2(qAbs(supply - 12.4) < 0.2, qPrintable(QString::number(supply)));
            }
        }
        QVERIFY2(good > turns / 2, qPrintable(QString::number(good)));
    }
};

QTEST_GUILESS_MAIN(TstMk14Simulator)
#include "tst_mk14simulator.moc"
