#include "core/alarms/noticepace.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

Alarm alarm(quint64 id, int number, StatusCode code = StatusCode::NoAnswer)
{
    Alarm alarm;
    alarm.id = id;
    alarm.port = 1;
    alarm.number = number;
    alarm.code = code;
    return alarm;
}

constexpr SteadyTime start{std::chrono::hours(1)};

} // namespace

/// With the limits of the product: 2 s of gathering, 10 s of distance, 5 min before a repetition.
class TestNoticePace : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsDueAtFirst()
    {
        NoticePace pace{{}};
        QVERIFY(!pace.dueAt());
        QVERIFY(pace.take({alarm(1, 1)}, start).isEmpty());
    }

    void whatComesTogetherIsToldTogether()
    {
        NoticePace pace{{}};
        pace.add(alarm(1, 1), start);
        pace.add(alarm(2, 2), start + 1900ms);
        QCOMPARE(*pace.dueAt(), start + 2s);
        const Alarms both{alarm(1, 1), alarm(2, 2)};
        QVERIFY(pace.take(both, start + 1999ms).isEmpty()); // a timer that fires early
        QCOMPARE(*pace.dueAt(), start + 2s);
        QCOMPARE(pace.take(both, start + 2s), both);
        QVERIFY(!pace.dueAt());
        QVERIFY(pace.take(both, start + 60s).isEmpty()); // once
    }

    void notificationsKeepTheirDistance()
    {
        NoticePace pace{{}};
        pace.add(alarm(1, 1), start);
        QCOMPARE(pace.take({alarm(1, 1)}, start + 2s).size(), 1);
        QVERIFY(!pace.dueAt());
        pace.add(alarm(2, 2), start + 3s);
        pace.add(alarm(3, 3), start + 8s);
        QCOMPARE(*pace.dueAt(), start + 12s);
        QCOMPARE(pace.take({alarm(1, 1), alarm(2, 2), alarm(3, 3)}, start + 12s).size(), 2);
        pace.add(alarm(4, 4), start + 60s);
        QCOMPARE(*pace.dueAt(), start + 62s); // long ago: no waiting but the gathering
    }

    void whatIsGoneOrAcceptedIsNotTold()
    {
        NoticePace pace{{}};
        pace.add(alarm(1, 1), start);
        pace.add(alarm(2, 2), start);
        QCOMPARE(pace.take({alarm(2, 2)}, start + 2s), Alarms{alarm(2, 2)});
        pace.add(alarm(3, 3), start + 13s);
        QVERIFY(pace.take({}, start + 15s).isEmpty());
        QVERIFY(!pace.dueAt());
        pace.add(alarm(4, 3), start + 16s);
        QCOMPARE(*pace.dueAt(), start + 18s); // an empty notification is none: it keeps nobody waiting
    }

    /// A loose cable: the sensor comes and goes every six seconds for ten minutes.
    void aFlappingSensorIsToldEveryFiveMinutes()
    {
        NoticePace pace{{}};
        QList<int> toldAt;
        quint64 id = 0;
        for (int second = 0; second < 600; ++second) {
            const SteadyTime now = start + std::chrono::seconds(second);
            const bool isStanding = second % 6 < 4;
            if (second % 6 == 0) {
                pace.add(alarm(++id, 1), now);
            }
            if (pace.dueAt() && now >= *pace.dueAt()
                && !pace.take(isStanding ? Alarms{alarm(id, 1)} : Alarms{}, now).isEmpty()) {
                toldAt.append(second);
            }
        }
        QVERIFY2(toldAt.size() == 2, qPrintable(QString::number(toldAt.size())));
        QVERIFY(toldAt.at(1) - toldAt.at(0) >= 300);
    }

    void anotherFaultOfAFlappingSensorIsToldAtOnce()
    {
        NoticePace pace{{}};
        pace.add(alarm(1, 1), start);
        pace.take({alarm(1, 1)}, start + 2s);
        pace.add(alarm(2, 1), start + 20s);
        QCOMPARE(*pace.dueAt(), start + 302s);
        pace.add(alarm(3, 1, StatusCode::CrcErrors), start + 30s);
        QCOMPARE(*pace.dueAt(), start + 32s);
        QCOMPARE(
            pace.take({alarm(3, 1, StatusCode::CrcErrors)}, start + 32s), Alarms{alarm(3, 1, StatusCode::CrcErrors)});
        QVERIFY(!pace.dueAt()); // what had waited is gone
    }

    void aFaultThatCameBackAndStaysIsToldInTheEnd()
    {
        NoticePace pace{{}};
        pace.add(alarm(1, 1), start);
        pace.take({alarm(1, 1)}, start + 2s);
        pace.add(alarm(2, 1), start + 20s);
        QVERIFY(pace.take({alarm(2, 1)}, start + 301s).isEmpty());
        QCOMPARE(*pace.dueAt(), start + 302s);
        QCOMPARE(pace.take({alarm(2, 1)}, start + 302s), Alarms{alarm(2, 1)});
    }
};

QTEST_GUILESS_MAIN(TestNoticePace)
#include "tst_noticepace.moc"
