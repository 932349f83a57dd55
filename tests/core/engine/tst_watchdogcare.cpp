#include "core/engine/watchdogcare.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

class TestWatchdogCare : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingToFeed()
    {
        WatchdogCare care({});
        care.restart(start);
        QVERIFY(!care.nextAt());
        QVERIFY(care.due(start + 1h).isEmpty());
    }

    void speaksWhenNobodyElseDoes()
    {
        WatchdogCare care(food);
        care.restart(start);
        QVERIFY(care.due(start + 9999ms).isEmpty());
        QCOMPARE(care.due(start + 10s), QByteArray("well"));
        care.look(4, start + 10s);
        QVERIFY(care.due(start + 19s).isEmpty());
        QVERIFY(care.nextAt() == start + 20s);
        QCOMPARE(care.due(start + 20s), QByteArray("well"));
    }

    void othersCount()
    {
        WatchdogCare care(food);
        care.restart(start);
        care.look(100, start + 8s);
        QVERIFY(care.nextAt() == start + 18s);
        care.look(100, start + 15s); // nothing was said since
        QVERIFY(care.nextAt() == start + 18s);
    }

    void isSilentOnceAnHour()
    {
        WatchdogCare care(food);
        care.restart(start);
        QVERIFY(!care.isSilent(start));
        QVERIFY(care.keepSilent(30s, start));
        QVERIFY(care.isSilent(start + 29s));
        QVERIFY(care.due(start + 29s).isEmpty()); // also the watchdog is to be hungry
        QVERIFY(!care.isSilent(start + 30s));
        QCOMPARE(care.due(start + 30s), QByteArray("well"));
        QVERIFY(!care.keepSilent(30s, start + 59min));
        QVERIFY(!care.isSilent(start + 59min));
        QVERIFY(care.keepSilent(30s, start + 60min));
        QVERIFY(care.isSilent(start + 60min + 29s));
    }

    void restartEndsTheSilence()
    {
        WatchdogCare care(food);
        QVERIFY(care.keepSilent(30s, start));
        care.restart(start + 1s);
        QVERIFY(!care.isSilent(start + 2s));
        QVERIFY(!care.keepSilent(30s, start + 2s)); // but that was one
    }

private:
    const SteadyTime start{1h};
    const KeepAlive food{"well", 10s};
};

QTEST_GUILESS_MAIN(TestWatchdogCare)
#include "tst_watchdogcare.moc"
