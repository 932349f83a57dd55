#include "tests/core/history/failingwrite.h"
#include "tests/core/mqtt/queuebench.h"

using namespace gorizont;
using namespace gorizont::test;

/// The queue of messages for a broker: order, acknowledgement, limits, restarts.
class TestMessageQueue : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesInOrderAndOnce();
    void numbersBeginWithTheTimeAndGoOn();
    void whatIsNotAcknowledgedComesAgain();
    void everythingComesAgainWithoutAMark_data();
    void everythingComesAgainWithoutAMark();
    void acknowledgedFilesAreRemoved();
    void whatFollowsTheAcknowledgedIsWhole();
    void oldestGoBeyondTheLimit();
    void limitHoldsForWhatWasFound();
    void memoryIsBoundedToo();
    void manyMessagesStayInOrderOverRestarts();
};

void TestMessageQueue::givesInOrderAndOnce()
{
    QueueBench bench;
    QVERIFY(!bench.queue->next());
    bench.append(3);
    QCOMPARE(bench.takeAll(), numbers(5000, 5002));
    QVERIFY(!bench.queue->next());
    bench.append(2);
    QCOMPARE(bench.takeAll(), numbers(5003, 5004));
    QCOMPARE(bench.queue->waiting(), 5U);
    bench.queue->acknowledge(5002);
    QCOMPARE(bench.queue->waiting(), 2U);
    bench.queue->rewind();
    QCOMPARE(bench.takeAll(), numbers(5003, 5004));
    QCOMPARE(bench.told, QStringList());
}

void TestMessageQueue::numbersBeginWithTheTimeAndGoOn()
{
    QueueBench bench;
    QCOMPARE(bench.queue->nextSequence(), 5000U);
    bench.append(2);
    bench.start();
    QCOMPARE(bench.queue->nextSequence(), 5002U);
    QCOMPARE(bench.takeAll(), numbers(5000, 5001));
    bench.queue->acknowledge(5001);
    bench.start();
    QCOMPARE(bench.queue->nextSequence(), 5002U);
    QVERIFY(!bench.queue->next());
    QVERIFY(QFile::remove(bench.pathOf(0)));
    bench.start(); // the mark alone remembers
    QCOMPARE(bench.queue->nextSequence(), 5002U);
    bench.append(1);
    QCOMPARE(bench.takeAll(), numbers(5002, 5002));
}

void TestMessageQueue::whatIsNotAcknowledgedComesAgain()
{
    QueueBench bench;
    bench.append(10);
    QCOMPARE(bench.takeAll().size(), 10);
    bench.queue->acknowledge(5003);
    bench.start();
    QCOMPARE(bench.queue->waiting(), 6U);
    QCOMPARE(bench.takeAll(), numbers(5004, 5009));
}

void TestMessageQueue::everythingComesAgainWithoutAMark_data()
{
    QTest::addColumn<QByteArray>("mark");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("zeros") << QByteArray(30, '\0');
    QTest::newRow("half") << QByteArray("66f5 50");
}

void TestMessageQueue::everythingComesAgainWithoutAMark()
{
    QFETCH(const QByteArray, mark);
    QueueBench bench;
    bench.append(10);
    QCOMPARE(bench.takeAll().size(), 10);
    bench.queue->acknowledge(5003);
    QFile file(bench.folder.filePath(QStringLiteral("Mqtt/acknowledged.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(mark);
    file.close();
    bench.start();
    QCOMPARE(bench.takeAll(), numbers(5000, 5009));
}

void TestMessageQueue::acknowledgedFilesAreRemoved()
{
    QueueBench bench(small(1'000'000, 500));
    for (int i = 0; i < 100; ++i) {
        bench.append(1, 80);
    }
    QVERIFY2(bench.fileNames().size() >= 10, qPrintable(bench.fileNames().join(u' ')));
    QCOMPARE(bench.fileNames().first(), QStringLiteral("queue-00000000000000005000.txt"));
    QCOMPARE(bench.takeAll(), numbers(5000, 5099));
    bench.queue->acknowledge(5050);
    QVERIFY(bench.queue->bytesOnDisk() < 7000);
    bench.queue->acknowledge(5099);
    QCOMPARE(bench.fileNames().size(), 1);
    QCOMPARE(bench.queue->waiting(), 0U);
    QCOMPARE(bench.queue->lost(), 0U);
}

/// The last file stays, and goes on after a start at which nothing in it was wanted.
void TestMessageQueue::whatFollowsTheAcknowledgedIsWhole()
{
    QueueBench bench;
    bench.append(100);
    QCOMPARE(bench.takeAll(), numbers(5000, 5099));
    bench.queue->acknowledge(5099);
    bench.start();
    QCOMPARE(bench.takeAll(), QList<quint64>());
    bench.append(3);
    QCOMPARE(bench.takeAll(), numbers(5100, 5102));
    QCOMPARE(bench.queue->lost(), 0U);
    QCOMPARE(bench.told, QStringList());
}

void TestMessageQueue::oldestGoBeyondTheLimit()
{
    QueueBench bench(small(5000, 500));
    for (int i = 0; i < 200; ++i) {
        bench.append(1, 80);
        QVERIFY(bench.queue->bytesOnDisk() <= 5000);
    }
    QVERIFY(bench.queue->bytesOnDisk() > 5000 - 700); // what fits is kept
    QCOMPARE(bench.told.size(), 1); // told once
    QVERIFY2(
        bench.told.first().startsWith(QStringLiteral("3 MQTT: the queue is full")), qPrintable(bench.told.first()));
    const quint64 lost = bench.queue->lost();
    QCOMPARE(lost + bench.queue->waiting(), 200U);
    QCOMPARE(bench.takeAll(), numbers(5000 + lost, 5199));
    bench.queue->acknowledge(5199);
    QCOMPARE(bench.told.size(), 2);
    QVERIFY2(bench.told.last().endsWith(QStringLiteral("readings: %1.").arg(lost)), qPrintable(bench.told.last()));
    bench.append(1);
    QCOMPARE(bench.takeAll(), numbers(5200, 5200));
}

void TestMessageQueue::limitHoldsForWhatWasFound()
{
    QueueBench bench(small(20000, 500));
    for (int i = 0; i < 100; ++i) {
        bench.append(1, 80);
    }
    bench.limits = small(3000, 500);
    bench.start();
    QVERIFY(bench.queue->bytesOnDisk() <= 3000);
    QCOMPARE(bench.takeAll(), numbers(5000 + bench.queue->lost(), 5099));
}

void TestMessageQueue::memoryIsBoundedToo()
{
    MessageQueue::Limits limits = small(1'000'000, 100'000);
    limits.memoryBytes = 2000;
    QueueBench bench(limits);
    const FailingWrite full(QStringLiteral(".txt"), 0);
    for (int i = 0; i < 100; ++i) {
        bench.append(1, 80);
    }
    QCOMPARE(bench.told.size(), 2); // not saved, full
    const quint64 waiting = bench.queue->waiting();
    QVERIFY(waiting > 5 && waiting < 20);
    QCOMPARE(bench.queue->lost(), 100 - waiting);
    QCOMPARE(bench.takeAll(), numbers(5100 - waiting, 5099));
}

void TestMessageQueue::manyMessagesStayInOrderOverRestarts()
{
    QueueBench bench(small(10'000'000, 20'000));
    QList<quint64> taken;
    for (int round = 0; round < 50; ++round) {
        bench.append(round * 7 % 400 + 1, 20 + round);
        for (int i = 0; i < 100; ++i) {
            const auto message = bench.queue->next();
            if (!message) {
                break;
            }
            bench.queue->acknowledge(message->sequence);
            taken.append(message->sequence);
        }
        if (round % 5 == 4) {
            bench.start();
        }
    }
    taken += bench.takeAll();
    QCOMPARE(taken, numbers(5000, bench.queue->nextSequence() - 1));
    QCOMPARE(bench.told, QStringList());
}

QTEST_GUILESS_MAIN(TestMessageQueue)
#include "tst_messagequeue.moc"
