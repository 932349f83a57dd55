#include "core/mqtt/messagequeue.h"
#include "tests/core/history/failingwrite.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <sys/fsuid.h>
#include <unistd.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr UtcTime firstStart{std::chrono::microseconds(5000)};

/// A folder, what the queue told, and a new queue on the folder as after a start of the program.
struct Bench
{
    explicit Bench(MessageQueue::Limits given = {})
        : limits(given)
    {
        start();
    }

    void start()
    {
        queue.reset();
        queue.emplace(folder.filePath(QStringLiteral("Mqtt")), limits, [this](JournalKind kind, const QString &text) {
            told.append(QString::number(static_cast<int>(kind)) + u' ' + text);
        });
        queue->open(firstStart);
    }

    void append(int count, int payloadSize = 20)
    {
        QList<QueuedMessage> messages;
        for (int i = 0; i < count; ++i) {
            const quint64 sequence = queue->nextSequence() + static_cast<quint64>(i);
            const QByteArray payload = QByteArray::number(sequence).rightJustified(payloadSize, '-');
            messages.append({sequence, QByteArrayLiteral("sensor/1/reading"), payload});
        }
        queue->append(messages);
    }

    /// The numbers that next() gives until it has nothing; the payload must be the one of the number.
    QList<quint64> takeAll()
    {
        QList<quint64> numbers;
        while (const auto message = queue->next()) {
            const bool isOwn = message->payload.endsWith(QByteArray::number(message->sequence));
            numbers.append(isOwn ? message->sequence : 0);
        }
        return numbers;
    }

    QStringList fileNames() const
    {
        return QDir(folder.filePath(QStringLiteral("Mqtt"))).entryList({QStringLiteral("queue-*")}, QDir::Files);
    }
    QString pathOf(qsizetype index) const
    {
        return folder.filePath(QStringLiteral("Mqtt/")) + fileNames().value(index);
    }
    QByteArray bytesOf(qsizetype index) const
    {
        QFile file(pathOf(index));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void overwrite(qsizetype index, const QByteArray &bytes) const
    {
        QFile file(pathOf(index));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    QTemporaryDir folder;
    MessageQueue::Limits limits;
    QStringList told;
    std::optional<MessageQueue> queue;
};

QList<quint64> numbers(quint64 first, quint64 last)
{
    QList<quint64> all;
    for (quint64 number = first; number <= last; ++number) {
        all.append(number);
    }
    return all;
}

MessageQueue::Limits small(qint64 bytes, qint64 segmentBytes)
{
    MessageQueue::Limits limits;
    limits.bytes = bytes;
    limits.segmentBytes = segmentBytes;
    limits.retry = 0ms;
    return limits;
}

} // namespace

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
    void fileOfAnotherUserIsRead();
    void tornTailOfAnyLengthCostsOneMessage();
    void tornTailIsFollowedByWholeMessages();
    void damageInTheMiddleCostsNoMoreThanItHit();
    void removedFileIsTold();
    void oldestGoBeyondTheLimit();
    void limitHoldsForWhatWasFound();
    void fullDiskStopsNothing();
    void memoryIsBoundedToo();
    void folderThatCannotBeMadeStopsNothing();
    void manyMessagesStayInOrderOverRestarts();
};

void TestMessageQueue::givesInOrderAndOnce()
{
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
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
    Bench bench(small(1'000'000, 500));
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
    Bench bench;
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

/// What a run as root left behind is sent, and new messages go into a file of their own.
void TestMessageQueue::fileOfAnotherUserIsRead()
{
    Bench bench;
    bench.append(3);
    bench.queue.reset();
    QVERIFY(QFile::setPermissions(bench.pathOf(0), QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther));
    const auto everybody = QFile::Permissions(0x7777);
    QVERIFY(QFile::setPermissions(bench.folder.path(), everybody));
    QVERIFY(QFile::setPermissions(bench.folder.filePath(QStringLiteral("Mqtt")), everybody));
    const auto owner = static_cast<uid_t>(::setfsuid(::geteuid() == 0 ? 65534 : ::geteuid())); // root may write all
    const auto back = qScopeGuard([owner] { ::setfsuid(owner); });
    bench.start();
    bench.append(2);
    QCOMPARE(bench.takeAll(), numbers(5000, 5004));
    bench.start();
    QCOMPARE(bench.takeAll(), numbers(5000, 5004));
}

void TestMessageQueue::tornTailOfAnyLengthCostsOneMessage()
{
    Bench bench;
    bench.append(3);
    const QByteArray whole = bench.bytesOf(0);
    const qsizetype lastLine = whole.lastIndexOf('\n', -2) + 1;
    QVERIFY(lastLine > 0);
    for (qsizetype size = lastLine + 1; size < whole.size(); ++size) {
        bench.told.clear();
        bench.overwrite(0, whole.first(size));
        bench.start();
        QCOMPARE(bench.takeAll(), numbers(5000, 5001));
        QCOMPARE(bench.queue->nextSequence(), 5002U);
        QCOMPARE(bench.told.size(), 1);
        QVERIFY2(
            bench.told.first().startsWith(QStringLiteral("0 MQTT: the queue did not end")),
            qPrintable(bench.told.first()));
        QCOMPARE(bench.bytesOf(0), whole.first(lastLine));
    }
    bench.told.clear();
    bench.overwrite(0, whole.first(lastLine));
    bench.start();
    QCOMPARE(bench.told, QStringList());
}

void TestMessageQueue::tornTailIsFollowedByWholeMessages()
{
    Bench bench;
    bench.append(3);
    bench.overwrite(0, bench.bytesOf(0).chopped(5));
    bench.start();
    bench.append(2);
    QCOMPARE(bench.takeAll(), numbers(5000, 5003));
    bench.start();
    QCOMPARE(bench.takeAll(), numbers(5000, 5003));
}

void TestMessageQueue::damageInTheMiddleCostsNoMoreThanItHit()
{
    Bench bench;
    bench.append(9);
    QByteArray bytes = bench.bytesOf(0);
    const qsizetype line = bytes.size() / 9;
    bytes.replace(line * 3 + 5, line * 2, QByteArray(line * 2, '\0')); // of the fourth, the whole fifth, of the sixth
    bench.overwrite(0, bytes);
    bench.start();
    QCOMPARE(bench.takeAll(), numbers(5000, 5002) + numbers(5006, 5008));
    QCOMPARE(bench.queue->lost(), 3U);
    QCOMPARE(bench.told.size(), 1);
    QVERIFY2(bench.told.first().endsWith(QStringLiteral("are lost: 3.")), qPrintable(bench.told.first()));
}

void TestMessageQueue::removedFileIsTold()
{
    Bench bench(small(1'000'000, 500));
    for (int i = 0; i < 30; ++i) {
        bench.append(1, 80);
    }
    const quint64 first = bench.fileNames().at(1).mid(6, 20).toULongLong();
    const quint64 end = bench.fileNames().at(2).mid(6, 20).toULongLong();
    QVERIFY(QFile::remove(bench.pathOf(1)));
    QCOMPARE(bench.takeAll(), numbers(5000, first - 1) + numbers(end, 5029));
    QCOMPARE(bench.queue->lost(), end - first);
}

void TestMessageQueue::oldestGoBeyondTheLimit()
{
    Bench bench(small(5000, 500));
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
    Bench bench(small(20000, 500));
    for (int i = 0; i < 100; ++i) {
        bench.append(1, 80);
    }
    bench.limits = small(3000, 500);
    bench.start();
    QVERIFY(bench.queue->bytesOnDisk() <= 3000);
    QCOMPARE(bench.takeAll(), numbers(5000 + bench.queue->lost(), 5099));
}

void TestMessageQueue::fullDiskStopsNothing()
{
    Bench bench(small(1'000'000, 100'000));
    bench.append(2);
    {
        const FailingWrite full(QStringLiteral(".txt"), 30); // not even one record
        bench.append(2);
        bench.append(2);
        QCOMPARE(bench.told.size(), 1);
        QVERIFY2(
            bench.told.first().startsWith(QStringLiteral("3 MQTT: the queue is not being saved: queue-")),
            qPrintable(bench.told.first()));
        QCOMPARE(bench.takeAll(), numbers(5000, 5005)); // it goes out all the same
        bench.queue->acknowledge(5003);
        QCOMPARE(bench.queue->waiting(), 2U);
        bench.queue->rewind();
        QCOMPARE(bench.takeAll(), numbers(5004, 5005));
    }
    bench.append(1);
    QCOMPARE(bench.told.size(), 2);
    QVERIFY2(bench.told.last().contains(QStringLiteral("is being saved again")), qPrintable(bench.told.last()));
    QCOMPARE(bench.takeAll(), numbers(5006, 5006));
    bench.start();
    const QList<quint64> again = bench.takeAll();
    QCOMPARE(again.last(3), numbers(5004, 5006)); // now they are on the disk
    QCOMPARE(bench.queue->lost(), 0U);
}

void TestMessageQueue::memoryIsBoundedToo()
{
    MessageQueue::Limits limits = small(1'000'000, 100'000);
    limits.memoryBytes = 2000;
    Bench bench(limits);
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

void TestMessageQueue::folderThatCannotBeMadeStopsNothing()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("file"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QStringList told;
    MessageQueue queue(path + QStringLiteral("/Mqtt"), {}, [&told](JournalKind, const QString &text) {
        told.append(text);
    });
    queue.open(firstStart);
    queue.append({{5000, QByteArrayLiteral("t"), QByteArrayLiteral("{}")}});
    QCOMPARE(told.size(), 1);
    QVERIFY(queue.next());
    queue.acknowledge(5000);
    QCOMPARE(queue.waiting(), 0U);
}

void TestMessageQueue::manyMessagesStayInOrderOverRestarts()
{
    Bench bench(small(10'000'000, 20'000));
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
