#include "core/engine/pollingcycle.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

Timing timing(std::chrono::milliseconds run, std::chrono::milliseconds idle)
{
    Timing timing;
    timing.run = run;
    timing.idle = idle;
    return timing;
}

const SteadyTime start{1h};

} // namespace

class TestPollingCycle : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsACycleEveryTmRun()
    {
        PollingCycle cycle(2, timing(1000ms, 1ms));
        cycle.restart(start);
        QCOMPARE(cycle.position(), 0);
        QVERIFY(cycle.nextTurnAt() == start);
        QVERIFY(!cycle.advance(start + 20ms, 0ms));
        QCOMPARE(cycle.position(), 1);
        QVERIFY(cycle.nextTurnAt() == start + 20ms);
        QVERIFY(cycle.advance(start + 40ms, 0ms));
        QVERIFY(cycle.isBetweenCycles());
        QVERIFY(cycle.nextTurnAt() == start + 1000ms);
    }

    void periodDoesNotDrift()
    {
        PollingCycle cycle(1, timing(1000ms, 1ms));
        cycle.restart(start);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(cycle.nextTurnAt() == start + i * 1000ms);
            cycle.advance(cycle.nextTurnAt() + 137ms, 0ms);
        }
    }

    void lateTurnsAreDropped()
    {
        PollingCycle cycle(1, timing(100ms, 5ms));
        cycle.restart(start);
        cycle.advance(start + 730ms, 0ms);
        QVERIFY(cycle.nextTurnAt() == start + 735ms); // SIdle after the end, not seven turns at once
        cycle.advance(start + 740ms, 0ms);
        QVERIFY(cycle.nextTurnAt() == start + 835ms); // and the grid has moved
    }

    void pauseAfterAnErrorHoldsUpTheNextTurn()
    {
        PollingCycle cycle(2, timing(1000ms, 1ms));
        cycle.restart(start);
        cycle.advance(start + 20ms, 600ms);
        QVERIFY(cycle.nextTurnAt() == start + 620ms);
        cycle.advance(start + 640ms, 600ms);
        QVERIFY(cycle.nextTurnAt() == start + 1240ms);
    }

    void aLineOfParkedSensorsDoesNotSpin()
    {
        PollingCycle cycle(2, timing(0ms, 0ms));
        cycle.restart(start);
        QVERIFY(!cycle.skip(start));
        QVERIFY(cycle.skip(start));
        QVERIFY(cycle.nextTurnAt() == start + 100ms); // PPauseTick
        cycle.skip(start + 100ms);
        cycle.advance(start + 110ms, 0ms);
        QVERIFY(cycle.nextTurnAt() == start + 110ms); // somebody was asked: as fast as TmRun and SIdle allow
    }
};

QTEST_APPLESS_MAIN(TestPollingCycle)
#include "tst_pollingcycle.moc"
