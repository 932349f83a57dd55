#include "core/engine/sensorhealth.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const SteadyTime start{1h};

} // namespace

class TestSensorHealth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void parksOnlyAtTheLimit()
    {
        SensorHealth health(3, 5);
        health.failed(Fault::Timeout, start);
        health.failed(Fault::BadReply, start);
        QVERIFY(!health.isParked());
        QVERIFY(health.isDue(start));
        health.failed(Fault::Timeout, start);
        QVERIFY(health.isParked());
        QVERIFY(!health.isDue(start));
        QCOMPARE(health.readErrorsInRow(), 3);
        QCOMPARE(health.crcErrorsInRow(), 0);
    }

    void checksumErrorsHaveTheirOwnLimit()
    {
        SensorHealth health(3, 2);
        health.failed(Fault::Checksum, start);
        health.failed(Fault::Timeout, start);
        QVERIFY(!health.isParked());
        health.failed(Fault::Checksum, start);
        QVERIFY(health.isParked());
        QCOMPARE(health.crcErrorsInRow(), 2);
        QCOMPARE(health.readErrorsInRow(), 1);
    }

    void probesAtGrowingIntervals()
    {
        SensorHealth health(1, 1);
        SteadyTime at = start;
        for (const auto pause : {2s, 4s, 8s, 16s, 30s, 30s}) {
            health.failed(Fault::Timeout, at);
            QVERIFY(!health.isDue(at + pause - 1ms));
            QVERIFY(health.isDue(at + pause));
            at += pause;
        }
    }

    void aGoodAnswerForgivesEverything()
    {
        SensorHealth health(1, 1);
        health.failed(Fault::Timeout, start);
        health.failed(Fault::Checksum, start);
        health.succeeded();
        QVERIFY(!health.isParked());
        QCOMPARE(health.readErrorsInRow(), 0);
        QCOMPARE(health.crcErrorsInRow(), 0);
        health.failed(Fault::Timeout, start);
        QVERIFY(health.isDue(start + 2s)); // the intervals start anew
    }
};

QTEST_APPLESS_MAIN(TestSensorHealth)
#include "tst_sensorhealth.moc"
