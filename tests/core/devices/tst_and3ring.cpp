#include "core/devices/and3/and3ring.h"
#include "tests/core/devices/and3frames.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

using Change = RingReader::Change;

constexpr UtcTime noon{std::chrono::seconds(1'700'000'000)};

Packet packet(quint64 number)
{
    Packet made;
    made.x = QList<qint16>(32, static_cast<qint16>(number));
    made.y = QList<qint16>(32, 1);
    made.start = number * ticksInPacket;
    made.stop = made.start + ticksInPacket;
    made.drz = 324;
    return made;
}

QList<Packet> packets(quint64 first, int count)
{
    QList<Packet> made;
    for (int i = 0; i < count; ++i) {
        made.append(packet(first + static_cast<quint64>(i)));
    }
    return made;
}

/// Reads all there is; the numbers of the packets, as their cells say in a run below 128 packets.
void readAll(RingReader &ring, quint64 &next)
{
    while (ring.available() > 0) {
        const auto step = ring.nextStep();
        QCOMPARE(step.firstCell, static_cast<int>(next % 128));
        const auto taken = ring.take(packets(next, step.count));
        QCOMPARE(taken.blocks.size(), step.count);
        QVERIFY(!taken.isOutOfStep);
        next += static_cast<quint64>(step.count);
    }
}

} // namespace

class TstAnd3Ring : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void firstStart_data();
    void firstStart();
    void steps_data();
    void steps();
    void steadyState();
    void nothingReadYetIsNothingLost();
    void overrun();
    void justNoOverrun();
    void countThatWentBackIsARestart();
    void rebootIsARestart();
    void countWraps();
    void outOfStep();
    void rejectedPacket();
    void timeGoesOnBySampleCount();
    void timeIsAnchoredAnew_data();
    void timeIsAnchoredAnew();
    void timeAfterAGap();
};

void TstAnd3Ring::firstStart_data()
{
    QTest::addColumn<quint32>("samples");
    QTest::addColumn<quint64>("available");
    QTest::addColumn<int>("firstCell");
    QTest::newRow("just switched on") << quint32(0) << quint64(0) << 0;
    QTest::newRow("no whole packet") << quint32(31) << quint64(0) << 0;
    QTest::newRow("one packet") << quint32(32) << quint64(1) << 0;
    QTest::newRow("119 packets") << quint32(119 * 32 + 31) << quint64(119) << 0;
    QTest::newRow("120 packets") << quint32(120 * 32) << quint64(119) << 1;
    QTest::newRow("months") << quint32(1000 * 32) << quint64(119) << 881 % 128;
}

void TstAnd3Ring::firstStart()
{
    QFETCH(quint32, samples);
    QFETCH(quint64, available);
    QFETCH(int, firstCell);
    RingReader ring(1, -0.006);
    QVERIFY(ring.observe(samples, false, noon) == Change::None);
    QCOMPARE(ring.available(), available);
    QCOMPARE(ring.nextStep().firstCell, firstCell);
    QVERIFY(ring.progress() == (RingProgress{samples / 32, 0}));
}

void TstAnd3Ring::steps_data()
{
    QTest::addColumn<quint32>("packets");
    QTest::addColumn<int>("firstCell");
    QTest::addColumn<int>("count");
    QTest::newRow("one") << quint32(1) << 0 << 1;
    QTest::newRow("three") << quint32(3) << 0 << 3;
    QTest::newRow("more than one answer") << quint32(9) << 0 << 4;
    QTest::newRow("up to the last cell") << quint32(124 + 119) << 124 << 4;
    QTest::newRow("not across the last cell") << quint32(126 + 119) << 126 << 2;
    QTest::newRow("the last cell") << quint32(127 + 119) << 127 << 1;
    QTest::newRow("the first cell again") << quint32(128 + 119) << 0 << 4;
}

void TstAnd3Ring::steps()
{
    QFETCH(quint32, packets);
    QFETCH(int, firstCell);
    QFETCH(int, count);
    RingReader ring(1, -0.006);
    ring.observe(packets * 32, false, noon);
    QCOMPARE(ring.nextStep().firstCell, firstCell);
    QCOMPARE(ring.nextStep().count, count);
}

/// 300 packets, one more at each observation: over the end of the ring twice.
void TstAnd3Ring::steadyState()
{
    RingReader ring(1, -0.006);
    quint64 next = 0;
    for (quint32 total = 0; total <= 300; ++total) {
        QVERIFY(ring.observe(total * 32 + 7, false, noon + total * 3200ms) == Change::None);
        QCOMPARE(ring.available(), quint64(total) - next);
        readAll(ring, next);
        QCOMPARE(next, quint64(total));
    }
    QVERIFY(ring.progress() == (RingProgress{300, 300}));
}

void TstAnd3Ring::nothingReadYetIsNothingLost()
{
    RingReader ring(1, -0.006);
    ring.observe(500 * 32, false, noon);
    QVERIFY(ring.observe(510 * 32, false, noon + 32s) == Change::None);
    QCOMPARE(ring.available(), quint64(119));
    QCOMPARE(ring.nextStep().firstCell, 391 % 128);
}

void TstAnd3Ring::justNoOverrun()
{
    RingReader ring(1, -0.006);
    ring.observe(10 * 32, false, noon);
    quint64 next = 0;
    readAll(ring, next);
    QVERIFY(ring.observe(129 * 32 + 31, false, noon + 381s) == Change::None);
    QCOMPARE(ring.available(), quint64(119));
    const auto taken = ring.take(packets(10, ring.nextStep().count));
    QVERIFY(taken.blocks.first().followsPrevious);
}

void TstAnd3Ring::overrun()
{
    RingReader ring(1, -0.006);
    ring.observe(10 * 32, false, noon);
    quint64 next = 0;
    readAll(ring, next);
    QVERIFY(ring.observe(130 * 32, false, noon + 384s) == Change::Overran);
    QCOMPARE(ring.lost(), quint64(119));
    QCOMPARE(ring.available(), quint64(1));
    QCOMPARE(ring.nextStep().firstCell, 129 % 128);
    const auto taken = ring.take({packet(129)});
    QVERIFY(!taken.isOutOfStep);
    QVERIFY(!taken.blocks.first().followsPrevious);
    // and on it goes
    QVERIFY(ring.observe(131 * 32, false, noon + 388s) == Change::None);
    QVERIFY(ring.take({packet(130)}).blocks.first().followsPrevious);
    QVERIFY(ring.progress() == (RingProgress{131, 12}));
}

void TstAnd3Ring::countThatWentBackIsARestart()
{
    RingReader ring(1, -0.006);
    ring.observe(10 * 32, false, noon);
    quint64 next = 0;
    readAll(ring, next);
    QVERIFY(ring.observe(2 * 32 + 5, false, noon + 60s) == Change::Restarted);
    QCOMPARE(ring.available(), quint64(2));
    QCOMPARE(ring.nextStep().firstCell, 0);
    const auto taken = ring.take(packets(0, 2));
    QVERIFY(!taken.blocks.at(0).followsPrevious);
    QVERIFY(taken.blocks.at(1).followsPrevious);
    QVERIFY(!taken.isOutOfStep);
    QVERIFY(ring.progress() == (RingProgress{2, 12}));
}

/// The new run is longer than the old one already: only the flag tells.
void TstAnd3Ring::rebootIsARestart()
{
    RingReader ring(1, -0.006);
    ring.observe(2 * 32, true, noon);
    quint64 next = 0;
    readAll(ring, next);
    QVERIFY(ring.observe(50 * 32, true, noon + 200s) == Change::Restarted);
    QCOMPARE(ring.available(), quint64(50));
    QCOMPARE(ring.nextStep().firstCell, 0);
    QVERIFY(!ring.take(packets(0, 4)).blocks.first().followsPrevious);
}

void TstAnd3Ring::countWraps()
{
    RingReader ring(1, -0.006);
    ring.observe(0xFFFF'FFE0, false, noon); // 2^32 − 32: 134217727 packets
    quint64 next = 134217727 - 119;
    readAll(ring, next);
    QVERIFY(ring.observe(64, false, noon + 10s) == Change::None);
    QCOMPARE(ring.available(), quint64(3));
    QCOMPARE(ring.nextStep().firstCell, 127);
    QCOMPARE(ring.nextStep().count, 1);
    QVERIFY(ring.take({packet(134217727)}).blocks.first().followsPrevious);
    QCOMPARE(ring.nextStep().firstCell, 0);
    QCOMPARE(ring.progress().packetsMeasured, quint64(134217730));
}

void TstAnd3Ring::outOfStep()
{
    RingReader ring(1, -0.006);
    ring.observe(4 * 32, false, noon);
    Packet late = packet(2);
    late.start += 1;
    const auto taken = ring.take({packet(0), packet(1), late, packet(3)});
    QVERIFY(taken.isOutOfStep);
    QCOMPARE(taken.blocks.size(), 4);
    const QList<bool> expected{false, true, false, true};
    for (int i = 0; i < 4; ++i) {
        QCOMPARE(taken.blocks.at(i).followsPrevious, expected.at(i));
    }
}

void TstAnd3Ring::rejectedPacket()
{
    RingReader ring(1, -0.006);
    ring.observe(4 * 32, false, noon);
    Packet bad = packet(1);
    bad.errors = 1;
    const auto taken = ring.take({packet(0), bad, packet(2), packet(3)});
    QCOMPARE(taken.rejected, 1);
    QVERIFY(!taken.isOutOfStep);
    QCOMPARE(taken.blocks.size(), 3);
    QVERIFY(!taken.blocks.at(1).followsPrevious);
    QCOMPARE(taken.blocks.at(1).x.first(), qint16(2));
    QVERIFY(taken.blocks.at(2).followsPrevious);
    QCOMPARE(ring.progress().packetsRead, quint64(4));
    QCOMPARE(ring.available(), quint64(0));
}

/// Polls come a little early or late; the time of the samples does not follow them.
void TstAnd3Ring::timeGoesOnBySampleCount()
{
    RingReader ring(7, -0.006);
    ring.observe(32 + 5, false, noon);
    const auto first = ring.take({packet(0)}).blocks.first();
    QCOMPARE(first.number, 7);
    QCOMPARE(first.rate, 10.0);
    QCOMPARE(first.scale, -0.006);
    QVERIFY(first.start == noon - 3700ms);
    ring.observe(64 + 5, false, noon + 3200ms + 400ms);
    QVERIFY(ring.take({packet(1)}).blocks.first().start == noon - 500ms);
    ring.observe(96 + 5, false, noon + 6400ms - 900ms);
    QVERIFY(ring.take({packet(2)}).blocks.first().start == noon + 2700ms);
}

void TstAnd3Ring::timeIsAnchoredAnew_data()
{
    QTest::addColumn<qint64>("step"); // ms that the host's clock moved
    QTest::addColumn<bool>("isAnchoredAnew");
    QTest::newRow("a second") << qint64(1000) << false;
    QTest::newRow("more than a second") << qint64(1001) << true;
    QTest::newRow("an hour back") << qint64(-3'600'000) << true;
    QTest::newRow("a second back") << qint64(-1000) << false;
}

void TstAnd3Ring::timeIsAnchoredAnew()
{
    QFETCH(qint64, step);
    QFETCH(bool, isAnchoredAnew);
    RingReader ring(1, -0.006);
    ring.observe(32, false, noon);
    ring.take({packet(0)});
    const std::chrono::milliseconds moved(step);
    ring.observe(64, false, noon + 3200ms + moved);
    const auto block = ring.take({packet(1)}).blocks.first();
    QVERIFY(block.start == (isAnchoredAnew ? noon + moved : noon));
    QVERIFY(block.followsPrevious); // no sample is missing, whatever the clock says
}

void TstAnd3Ring::timeAfterAGap()
{
    RingReader ring(1, -0.006);
    ring.observe(32, false, noon);
    ring.take({packet(0)});
    ring.observe(64, false, noon + 3200ms + 300ms);
    Packet apart = packet(1);
    apart.start += 5;
    QVERIFY(ring.take({apart}).blocks.first().start == noon + 300ms);
}

QTEST_GUILESS_MAIN(TstAnd3Ring)
#include "tst_and3ring.moc"
