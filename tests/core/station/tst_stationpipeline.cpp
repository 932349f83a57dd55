#include "tests/core/station/stationbench.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The work of a second, from raw values to what is answered (spec/mk14.md, "Processing").
class TestStationPipeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void statisticsOfAWindow()
    {
        StationConfig config = stationOf({parameter('T')});
        config.parameters[0].name = QStringLiteral("Air");
        config.parameters[0].unit = QStringLiteral("°C");
        config.parameters[0].averaging = 5s;
        config.parameters[0].conversion.coefficients = {0, 10};
        BoardConfig board;
        board.instantSeconds = 2;
        config.boards = {board};
        StationBench bench(config);
        for (const double value : {100.0, 0.1, 0.2, 0.4, 0.3, 0.7}) {
            bench.step({value});
        }
        const WeatherParameter &air = bench.at(0);
        QCOMPARE(air.code, QChar(u'T'));
        QCOMPARE(air.name, QStringLiteral("Air"));
        QCOMPARE(air.unit, QStringLiteral("°C"));
        QCOMPARE(*air.mean, 3.4);
        QCOMPARE(*air.instant, 5.0);
        QCOMPARE(*air.minimum, 1.0);
        QCOMPARE(*air.maximum, 7.0);
        QCOMPARE(*air.voltage, 0.34);
        QCOMPARE(*air.voltageInstant, 0.5);
        QCOMPARE(*air.maxPeriod, 1000.0);
        QVERIFY(qAbs(*air.deviation - 2.0591260281974) < 1e-9);
        QCOMPARE(bench.pipeline.sentParameters(), 1);
        QCOMPARE(bench.pipeline.physical(0), 7.0);
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good);
    }

    void theWindowOfTheStationWhereTheParameterHasNone()
    {
        StationConfig config = stationOf({parameter('T')});
        config.parameters[0].averaging = 0s;
        config.settings.averaging = 2s;
        StationBench bench(config);
        bench.step({100});
        bench.step({4});
        bench.step({6});
        QCOMPARE(*bench.at(0).mean, 5.0);
    }

    /// 50 % of ten: five are not more than half, six are.
    void percentOfGoodValues()
    {
        StationBench bench(stationOf({parameter('T')}));
        bench.step({3}, 5);
        QVERIFY(!bench.at(0).mean);
        QVERIFY(!bench.at(0).minimum);
        QVERIFY(!bench.at(0).maximum);
        QVERIFY(!bench.at(0).deviation);
        QCOMPARE(bench.at(0).instant, 3.0);
        bench.step({3});
        QCOMPARE(bench.at(0).mean, 3.0);
        QCOMPARE(bench.at(0).minimum, 3.0);
        bench.step({{}}, 4);
        QCOMPARE(bench.at(0).mean, 3.0);
        QVERIFY(!bench.at(0).instant);
        bench.step({{}}); // the first value leaves
        QVERIFY(!bench.at(0).mean);
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Missing);
    }

    void percentNone()
    {
        StationConfig config = stationOf({parameter('T')});
        config.settings.goodPercent = 0;
        StationBench bench(config);
        bench.step({{}});
        QVERIFY(!bench.at(0).mean);
        bench.step({7});
        QCOMPARE(bench.at(0).mean, 7.0);
    }

    void withoutDeviation()
    {
        StationConfig config = windStation();
        config.settings.hasDeviation = false;
        StationBench bench(config);
        bench.step({90, 5}, 10);
        QVERIFY(bench.at(0).mean && bench.at(1).mean);
        QVERIFY(!bench.at(0).deviation && !bench.at(1).deviation);
    }

    void outsideTheLimits()
    {
        StationConfig config = stationOf({parameter('T')});
        config.parameters[0].limits = {-60, 60};
        StationBench bench(config);
        bench.step({20}, 9);
        bench.step({61});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::OutsideLimits);
        QCOMPARE(bench.at(0).mean, 20.0);
        QVERIFY(!bench.at(0).instant);
        QCOMPARE(bench.at(0).maxPeriod, 20.0);
        QCOMPARE(bench.at(0).voltageInstant, 61.0); // so that one sees why
    }

    /// The gate compares with the mean of the window; the first value passes, and so does the first after ten without a good one.
    void errorGate()
    {
        StationConfig config = stationOf({parameter('T')});
        config.parameters[0].error = 1;
        StationBench bench(config);
        bench.step({20});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good);
        bench.step({21});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good); // mean 20
        bench.step({21.6});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::FarFromMean); // mean 20.5
        bench.step({21.5});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good);
        bench.step({40}, 10);
        QCOMPARE(bench.pipeline.verdict(0), Verdict::FarFromMean); // the last good one has only just left
        bench.step({40});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good);
        QCOMPARE(bench.pipeline.physical(0), 40.0);
    }

    /// Also when the board does not put it first, and for all of that second only.
    void supplyVoltage()
    {
        StationConfig config = stationOf({parameter('T'), parameter('U'), parameter('M'), parameter('A')});
        config.parameters[1].limits = {10, 14};
        StationBench bench(config);
        bench.step({20, {}, 5, 90});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good); // never measured: not judged
        bench.step({20, 9.9, 5, 90});
        QCOMPARE(bench.pipeline.verdict(1), Verdict::OutsideLimits);
        for (const int index : {0, 2, 3}) {
            QCOMPARE(bench.pipeline.verdict(index), Verdict::SupplyBad);
            QVERIFY(!bench.at(index).instant);
        }
        bench.step({20, 12, 5, 90});
        for (const int index : {0, 1, 2, 3}) {
            QCOMPARE(bench.pipeline.verdict(index), Verdict::Good);
        }
        bench.step({20, {}, 5, 90});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::SupplyBad); // it was measured before
        bench.step({{}, 12, 5, 90});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Missing);
    }

    void oneOfTwoSupplies()
    {
        StationConfig config = stationOf({parameter('U', 1), parameter('U', 2)});
        config.parameters[1].limits = {10, 14};
        StationBench bench(config);
        bench.step({12, 20});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::SupplyBad);
        QCOMPARE(bench.pipeline.verdict(1), Verdict::OutsideLimits);
    }

    void maximumSinceTheLastRequest()
    {
        StationConfig config = stationOf({parameter('T')});
        config.settings.maximumHold = 182; // 10 s
        StationBench bench(config);
        bench.step({50});
        bench.step({20}, 30);
        QCOMPARE(bench.at(0).maxPeriod, 50.0); // however long ago
        bench.pipeline.requested(bench.now());
        bench.step({21}, 5);
        bench.pipeline.requested(bench.now()); // within the hold: changes nothing
        bench.step({21}, 5);
        QCOMPARE(bench.at(0).maxPeriod, 50.0);
        bench.step({22});
        QCOMPARE(bench.at(0).maxPeriod, 22.0);
        bench.step({21}, 20);
        QCOMPARE(bench.at(0).maxPeriod, 22.0); // no more requests, no new beginning
    }

    void maximumWithoutAHold()
    {
        StationBench bench(stationOf({parameter('T')}));
        bench.step({50});
        bench.pipeline.requested(bench.now());
        QCOMPARE(bench.at(0).maxPeriod, 50.0);
        bench.step({{}});
        QVERIFY(!bench.at(0).maxPeriod);
        bench.step({1});
        QCOMPARE(bench.at(0).maxPeriod, 1.0);
    }

    void testMode_data()
    {
        QTest::addColumn<bool>("isOfTheBoard");
        QTest::newRow("ACK.PSE") << false;
        QTest::newRow("board") << true;
    }

    /// No conversion, no limits, no gate, no supply, no share of good values, no components of wind.
    void testMode()
    {
        QFETCH(const bool, isOfTheBoard);
        StationConfig config = windStation();
        config.parameters.append(parameter('U'));
        config.parameters.append(parameter('T'));
        config.corrections.resize(4);
        config.parameters[2].limits = {10, 14};
        config.parameters[3].conversion.coefficients = {100, 7};
        config.parameters[3].limits = {0, 1};
        config.parameters[3].error = 0;
        config.settings.isTest = !isOfTheBoard;
        BoardConfig board;
        board.isTest = isOfTheBoard;
        config.boards = {board};
        StationBench bench(config);
        bench.step({700, 0, 1, 2.5});
        bench.step({500, 0, 1, 3.5});
        QCOMPARE(bench.at(3).mean, 3.0);
        QCOMPARE(bench.at(0).mean, 600.0);
        QCOMPARE(bench.at(2).mean, 1.0);
        QCOMPARE(bench.pipeline.weather().parameters.size(), 4);
        bench.step({qQNaN(), 0, 1, qInf()});
        QCOMPARE(bench.pipeline.verdict(3), Verdict::Missing);
        QCOMPARE(bench.at(3).mean, 3.0);
    }

    /// t is the last good second of the thermometer: of this second when it is processed before, else of the one before.
    void temperatureOfCorrections_data()
    {
        QTest::addColumn<bool>("isThermometerFirst");
        QTest::newRow("thermometer first") << true;
        QTest::newRow("thermometer last") << false;
    }

    void temperatureOfCorrections()
    {
        QFETCH(const bool, isThermometerFirst);
        StationConfig config = stationOf({parameter('T'), parameter('P')});
        config.parameters[0].limits = {-60, 60};
        config.corrections[1].meteo.rows = {{100, {0, 1}}};
        BoardConfig board;
        board.order = isThermometerFirst ? QList<BoardInput>{{0, {u'T', 1}}, {1, {u'P', 1}}}
                                         : QList<BoardInput>{{0, {u'P', 1}}, {1, {u'T', 1}}};
        config.boards = {board};
        StationBench bench(config);
        bench.step({{}, 700});
        QCOMPARE(bench.pipeline.physical(1), 700.0); // no temperature yet: no correction
        bench.step({20, 700});
        QCOMPARE(bench.pipeline.physical(1), isThermometerFirst ? 720.0 : 700.0);
        bench.step({30, 700});
        QCOMPARE(bench.pipeline.physical(1), isThermometerFirst ? 730.0 : 720.0);
        bench.step({99, 700}); // outside its limits
        bench.step({{}, 700});
        QCOMPARE(bench.pipeline.physical(1), 730.0);
    }

    void inputHasItsOwnThermometer()
    {
        StationConfig config = stationOf({parameter('T'), parameter('f'), parameter('P')});
        config.corrections[2].input.rows = {{100, {0, 1}}};
        config.corrections[2].inputThermometer = ParameterId{u'f', 1};
        config.corrections[2].meteo.rows = {{100, {0, 1000}}};
        StationBench bench(config);
        bench.step({2, 3, 700});
        QCOMPARE(bench.pipeline.physical(2), 700 + 3 + 2000.0);
    }

    void faultyCorrectionsGiveNoValues()
    {
        StationConfig config = stationOf({parameter('U'), parameter('P')});
        config.corrections[0].isFaulty = true;
        StationBench bench(config);
        bench.step({12, 700}, 10);
        QVERIFY(!bench.at(0).mean && !bench.at(0).voltage);
        QCOMPARE(bench.at(1).mean, 700.0); // a supply that has no values is not judged
    }

    void nothingMeasured()
    {
        StationBench bench(windStation());
        bench.step({}, 20);
        for (int i = 0; i < 3; ++i) {
            const WeatherParameter &parameter = bench.at(i);
            QVERIFY(!parameter.mean && !parameter.instant && !parameter.minimum && !parameter.maximum);
            QVERIFY(!parameter.voltage && !parameter.voltageInstant && !parameter.maxPeriod && !parameter.deviation);
        }
    }

    void noParameters()
    {
        StationBench bench(StationConfig{});
        bench.step({1, 2, 3}, 3, 7);
        QCOMPARE(bench.pipeline.weather().digital, 7U);
        QCOMPARE(bench.pipeline.windExtras(), WindExtras());
    }

    /// A value beyond all measure passes no polynomial and leaves nothing in the windows.
    void overflow()
    {
        StationConfig config = stationOf({parameter('T')});
        config.parameters[0].conversion.coefficients = {0, 0, 1};
        config.settings.goodPercent = 0;
        StationBench bench(config);
        bench.step({2});
        bench.step({1e200});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Missing);
        QCOMPARE(bench.at(0).mean, 4.0);
    }
};

QTEST_GUILESS_MAIN(TestStationPipeline)
#include "tst_stationpipeline.moc"
