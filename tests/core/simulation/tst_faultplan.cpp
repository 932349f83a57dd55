#include "core/simulation/faultplan.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;
using Kind = SimulatedFault::Kind;

class TestFaultPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsEveryKind()
    {
        const auto silent = parseSimulatedFault(QStringLiteral("silent=3"));
        QVERIFY(silent);
        QCOMPARE(*silent, (SimulatedFault{Kind::Silent, 3, 0s, 0s, SimulatedFault::Time::max()}));
        const auto crc = parseSimulatedFault(QStringLiteral("crc=2.5@10-20"));
        QVERIFY(crc);
        QCOMPARE(*crc, (SimulatedFault{Kind::Crc, 2.5, 0s, 10s, 20s}));
        const auto gone = parseSimulatedFault(QStringLiteral("gone=9:4@5.5"));
        QVERIFY(gone);
        QCOMPARE(*gone, (SimulatedFault{Kind::Gone, 9, 4s, 5500ms, SimulatedFault::Time::max()}));
        for (const char *text : {"garbage=100", "pieces=1", "late=0", "reboot=1@7", "overrun=12@300"}) {
            QVERIFY2(parseSimulatedFault(QString::fromLatin1(text)), text);
        }
    }

    void isActiveFromTo()
    {
        const auto crc = parseSimulatedFault(QStringLiteral("crc=1@10-20"));
        QVERIFY(!crc->isActive(10s - 1us));
        QVERIFY(crc->isActive(10s));
        QVERIFY(!crc->isActive(20s));
    }

    void refusesEverythingElse()
    {
        for (const char *text :
             {"", "silent", "silent=", "silent=x", "flood=1", "crc=101", "gone=9", "silent=3:4", "crc=1@", "crc=-1",
              "crc=1@20-", "silent=3 "}) {
            QVERIFY2(!parseSimulatedFault(QString::fromLatin1(text)), text);
        }
    }
};

QTEST_APPLESS_MAIN(TestFaultPlan)
#include "tst_faultplan.moc"
