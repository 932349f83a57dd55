#include "tests/core/devices/and3driverbench.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The half of the driver that reads the ring.
class TstAnd3Fetch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fetchBringsBlocks();
    void fetchInSteps();
    void fetchPatience();
    void afterAFailedFetchThePollComesFirst();
    void overrunStandsForOnePoll();
    void syncErrorStandsForOnePoll();
    void rejectedPacketIsAGap();
    void reopenedLineLosesNothing();
    void rebootBetweenPolls();
};

void TstAnd3Fetch::fetchBringsBlocks()
{
    DriverBench bench;
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.pollAt(31));
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.pollAt(32 + 4));
    QVERIFY(bench.driver.hasBacklog());
    const auto blocks = bench.fetch(0, 1);
    QVERIFY(blocks && blocks->size() == 1);
    const SampleBlock &block = blocks->first();
    QCOMPARE(block.number, 3);
    QCOMPARE(block.rate, 10.0);
    QCOMPARE(block.scale, accelerationScale(9.81347));
    QVERIFY(block.start == bench.now - 3600ms);
    QVERIFY(!block.followsPrevious);
    QCOMPARE(block.x.size(), 32);
    QCOMPARE(block.y.size(), 32);
    QCOMPARE(block.x.at(31), qint16(31));
    QCOMPARE(block.y.at(31), qint16(-31));
    QVERIFY(!bench.driver.hasBacklog());
    const auto read = bench.pollAt(40);
    QVERIFY(read && read->ring == (RingProgress{1, 1}));
    QVERIFY(bench.isClean());
}

/// The whole ring at the first start, four packets a step, cut at the last cell.
void TstAnd3Fetch::fetchInSteps()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(242 * 32)); // 123…241
    QList<SampleBlock> blocks;
    quint64 next = 123;
    for (const int count : {4, 1, 4, 4}) {
        QVERIFY(bench.driver.hasBacklog());
        const auto fetched = bench.fetch(next, count);
        QVERIFY(fetched);
        blocks += *fetched;
        next += static_cast<quint64>(count);
    }
    QCOMPARE(blocks.size(), 13);
    for (qsizetype i = 0; i < blocks.size(); ++i) {
        QCOMPARE(blocks.at(i).x.first(), static_cast<qint16>((123 + i) * 32));
        QCOMPARE(blocks.at(i).followsPrevious, i > 0);
    }
    QVERIFY(bench.isClean());
}

/// TORDat, not TORCom: the answer may take seconds.
void TstAnd3Fetch::fetchPatience()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(32));
    bench.line.expectPieces(askFirstPacket, {{packetsAnswer(0, 1), 3900ms}});
    QVERIFY(bench.driver.fetch(bench.line));
}

void TstAnd3Fetch::afterAFailedFetchThePollComesFirst()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(32));
    bench.line.expect(askFirstPacket, QByteArray());
    QCOMPARE(bench.driver.fetch(bench.line).fault(), Fault::Timeout);
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.pollAt(42));
    QVERIFY(bench.driver.hasBacklog());
    const auto blocks = bench.fetch(0, 1); // the same packet
    QVERIFY(blocks && blocks->size() == 1);
}

void TstAnd3Fetch::overrunStandsForOnePoll()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(32));
    QVERIFY(bench.fetch(0, 1));
    const auto overrun = bench.pollAt(200 * 32);
    QVERIFY(overrun && overrun->conditions.testFlag(Condition::RingOverrun));
    const QList<DriverNote> notes = bench.driver.takeNotes();
    QCOMPARE(notes.size(), 1);
    QCOMPARE(notes.first().kind, JournalKind::Error);
    QCOMPARE(notes.first().text, QStringLiteral("The buffer of accelerations overran, packets lost: 198."));
    const auto blocks = bench.fetch(199, 1);
    QVERIFY(blocks && !blocks->first().followsPrevious);
    const auto after = bench.pollAt(200 * 32 + 9);
    QVERIFY(after && !after->conditions.testFlag(Condition::RingOverrun));
    QVERIFY(!after->conditions.testFlag(Condition::SyncError));
    QVERIFY(bench.isClean());
}

void TstAnd3Fetch::syncErrorStandsForOnePoll()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(2 * 32));
    PacketText shifted = PacketText::numbered(1);
    shifted.start += 40;
    bench.line.expect(askPackets(0, 2), packetsAnswer(PacketText::numbered(0).toBytes() + shifted.toBytes()));
    const auto blocks = bench.driver.fetch(bench.line);
    QVERIFY(blocks && blocks->size() == 2 && !blocks->at(1).followsPrevious);
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("Packets of accelerations do not follow each other.")});
    bench.line.expect(askComplex, QByteArray());
    QVERIFY(!bench.driver.poll(bench.line)); // a failed poll does not use it up
    const auto first = bench.pollAt(74);
    QVERIFY(first && first->conditions.testFlag(Condition::SyncError));
    const auto second = bench.pollAt(84);
    QVERIFY(second && !second->conditions.testFlag(Condition::SyncError));
    QVERIFY(bench.isClean());
}

void TstAnd3Fetch::rejectedPacketIsAGap()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(3 * 32));
    PacketText bad = PacketText::numbered(1);
    bad.drz = 323;
    bench.line.expect(
        askPackets(0, 3),
        packetsAnswer(PacketText::numbered(0).toBytes() + bad.toBytes() + PacketText::numbered(2).toBytes()));
    const auto blocks = bench.driver.fetch(bench.line);
    QVERIFY(blocks && blocks->size() == 2);
    QCOMPARE(blocks->at(1).x.first(), qint16(64));
    QVERIFY(!blocks->at(1).followsPrevious);
    const auto after = bench.pollAt(3 * 32 + 10);
    QVERIFY(after && !after->conditions.testFlag(Condition::SyncError));
    QVERIFY(after->ring == (RingProgress{3, 3}));
}

void TstAnd3Fetch::reopenedLineLosesNothing()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(2 * 32));
    QVERIFY(bench.fetch(0, 2));
    bench.driver.restart();
    QVERIFY(!bench.driver.hasBacklog());
    const auto read = bench.pollAt(110 * 32);
    QVERIFY(read && !read->conditions.testFlag(Condition::RingOverrun));
    const auto blocks = bench.fetch(2, 4);
    QVERIFY(blocks && blocks->first().followsPrevious);
    QVERIFY(bench.driver.takeNotes().isEmpty());
    QVERIFY(bench.isClean());
}

void TstAnd3Fetch::rebootBetweenPolls()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(2 * 32));
    QVERIFY(bench.fetch(0, 2));
    const auto read = bench.pollAt(5 * 32, rebooted); // longer than the old run
    QVERIFY(read && read->conditions.testFlag(Condition::Rebooted));
    const auto blocks = bench.fetch(0, 4);
    QVERIFY(blocks && !blocks->first().followsPrevious);
    QVERIFY(!bench.pollAt(5 * 32 + 9)->conditions.testFlag(Condition::SyncError));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("The sensor has restarted.")});
    // without the flag the count itself tells
    QVERIFY(bench.pollAt(7));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("The sensor counts its measurements anew.")});
}

QTEST_GUILESS_MAIN(TstAnd3Fetch)
#include "tst_and3fetch.moc"
