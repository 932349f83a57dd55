#include "tests/core/station/stationbench.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What is not an ordinary analogue value: wind, digital inputs, rain and the gamma sensor (manual 004, sections 5.2 and 5.3).
class TestStationInputs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wind()
    {
        StationBench bench(windStation());
        bench.step({350, 4});
        bench.step({10, 2});
        const Weather &weather = bench.pipeline.weather();
        QCOMPARE(weather.parameters.size(), 3);
        QCOMPARE(bench.pipeline.sentParameters(), 2);
        const WeatherParameter &direction = bench.at(0);
        QVERIFY(std::min(*direction.mean, 360 - *direction.mean) < 1e-9); // unweighted, whatever the percent
        QCOMPARE(direction.instant, 10.0);
        QVERIFY(!direction.minimum && !direction.maximum);
        QCOMPARE(direction.maxPeriod, 350.0); // of the gust
        QCOMPARE(bench.at(1).mean, 3.0);
        QCOMPARE(bench.at(1).maxPeriod, 4.0);
        const WeatherParameter *vector = weather.find(weathercode::windVector);
        QVERIFY(vector);
        QCOMPARE(vector->unit, QStringLiteral("m/s"));
        // hypot((4 sin 350 + 2 sin 10)/2, (4 cos 350 + 2 cos 10)/2) by Python
        QVERIFY(qAbs(*vector->mean - 2.9595220024766893) < 1e-9);
        QVERIFY(qAbs(*vector->instant - 2) < 1e-9);
        QVERIFY(!vector->maximum && !vector->voltage);
        const WindExtras expected{direction.deviation, bench.at(1).deviation, 4.0};
        QVERIFY(direction.deviation && bench.at(1).deviation);
        QCOMPARE(bench.pipeline.windExtras(), expected);
    }

    /// left 0.3 + error 0.7: below 1 m/s a direction does not count; the speed does.
    void calm()
    {
        StationBench bench(windStation());
        bench.step({90, 1.0});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Good);
        bench.step({180, 0.99});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Calm);
        QCOMPARE(bench.pipeline.verdict(1), Verdict::Good);
        QVERIFY(qAbs(*bench.at(0).mean - 90) < 1e-9);
        bench.step({180, {}});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Calm);
        QVERIFY(qAbs(*bench.at(2).mean - 1) < 1e-9);
        bench.step({361, 5});
        QCOMPARE(bench.pipeline.verdict(0), Verdict::OutsideLimits);
        QCOMPARE(bench.at(0).maxPeriod, std::nullopt); // a gust from nobody knows where
    }

    void windThatIsListed()
    {
        StationConfig config = windStation();
        config.parameters.prepend(parameter('W'));
        config.parameters[0].name = QStringLiteral("Vector");
        config.corrections.resize(3);
        StationBench bench(config);
        bench.step({77, 90, 6});
        QCOMPARE(bench.pipeline.weather().parameters.size(), 3);
        QVERIFY(qAbs(*bench.at(0).mean - 6) < 1e-9);
        QCOMPARE(bench.at(0).name, QStringLiteral("Vector"));
    }

    void twoMasts()
    {
        StationBench bench(stationOf({parameter('A', 1), parameter('M', 1), parameter('A', 2), parameter('M', 2)}));
        bench.step({0, 3, 90, 8});
        QVERIFY(qAbs(*bench.pipeline.weather().find(u'W', 1)->mean - 3) < 1e-9);
        QVERIFY(qAbs(*bench.pipeline.weather().find(u'W', 2)->mean - 8) < 1e-9);
    }

    void directionWithoutASpeed()
    {
        StationBench bench(stationOf({parameter('A')}));
        bench.step({90});
        QVERIFY(qAbs(*bench.at(0).mean - 90) < 1e-9);
        QCOMPARE(bench.pipeline.weather().parameters.size(), 1);
        QCOMPARE(bench.pipeline.windExtras().speedMaximum, std::nullopt);
    }

    void digitalInputs()
    {
        ParameterConfig door = parameter('D');
        door.conversion.coefficients = {0.5};
        door.limits = {0, 1};
        StationConfig config = stationOf({door});
        config.settings.goodPercent = 0;
        BoardConfig board;
        board.digital = {{0, {u'O', 1}}, {3, {u'D', 1}}};
        config.boards = {board};
        StationBench bench(config);
        bench.step({}, 1, 0b1000);
        QCOMPARE(bench.at(0).instant, 1.0);
        QCOMPARE(bench.pipeline.weather().digital, 0b1000U);
        bench.step({}, 1, 0b0001);
        QCOMPARE(bench.at(0).instant, 0.0);
        QCOMPARE(bench.at(0).mean, 0.5);
        bench.step({}); // the inputs were not read
        QCOMPARE(bench.pipeline.verdict(0), Verdict::Missing);
        QCOMPARE(bench.pipeline.weather().digital, 0b0001U);
        bench.step({}, 1, 0);
        const QList<PrecipitationEvent> expected{
            {false, StationBench::firstClock + 3}, {true, StationBench::firstClock + 1}};
        QCOMPARE(bench.pipeline.weather().events, expected);
    }

    void gammaSensor()
    {
        StationConfig config = stationOf({parameter('G')});
        GammaConfig gamma;
        gamma.parameter = {u'G', 1};
        gamma.sensitivity = 2;
        gamma.background = 4;
        config.gamma = gamma;
        StationBench direct(config);
        direct.step({10}, 20);
        QCOMPARE(direct.at(0).instant, 3.0);
        QVERIFY(!direct.at(0).mean && !direct.at(0).minimum && !direct.at(0).maximum && !direct.at(0).maxPeriod);
        QCOMPARE(direct.at(0).voltage, 10.0);
        config.gamma->sensitivity = 0;
        StationBench ordinary(config);
        ordinary.step({10}, 20);
        QCOMPARE(ordinary.at(0).mean, 10.0);
    }
};

QTEST_GUILESS_MAIN(TestStationInputs)
#include "tst_stationinputs.moc"
