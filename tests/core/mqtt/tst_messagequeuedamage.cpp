#include "tests/core/history/failingwrite.h"
#include "tests/core/mqtt/queuebench.h"

#include <sys/fsuid.h>
#include <unistd.h>

using namespace gorizont;
using namespace gorizont::test;

/// The queue of messages when its files, its folder or its disk are not as it left them.
class TestMessageQueueDamage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fileOfAnotherUserIsRead();
    void tornTailOfAnyLengthCostsOneMessage();
    void tornTailIsFollowedByWholeMessages();
    void damageInTheMiddleCostsNoMoreThanItHit();
    void removedFileIsTold();
    void fullDiskStopsNothing();
    void folderThatCannotBeMadeStopsNothing();
};

/// What a run as root left behind is sent, and new messages go into a file of their own.
void TestMessageQueueDamage::fileOfAnotherUserIsRead()
{
    QueueBench bench;
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

void TestMessageQueueDamage::tornTailOfAnyLengthCostsOneMessage()
{
    QueueBench bench;
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

void TestMessageQueueDamage::tornTailIsFollowedByWholeMessages()
{
    QueueBench bench;
    bench.append(3);
    bench.overwrite(0, bench.bytesOf(0).chopped(5));
    bench.start();
    bench.append(2);
    QCOMPARE(bench.takeAll(), numbers(5000, 5003));
    bench.start();
    QCOMPARE(bench.takeAll(), numbers(5000, 5003));
}

void TestMessageQueueDamage::damageInTheMiddleCostsNoMoreThanItHit()
{
    QueueBench bench;
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

void TestMessageQueueDamage::removedFileIsTold()
{
    QueueBench bench(small(1'000'000, 500));
    for (int i = 0; i < 30; ++i) {
        bench.append(1, 80);
    }
    const quint64 first = bench.fileNames().at(1).mid(6, 20).toULongLong();
    const quint64 end = bench.fileNames().at(2).mid(6, 20).toULongLong();
    QVERIFY(QFile::remove(bench.pathOf(1)));
    QCOMPARE(bench.takeAll(), numbers(5000, first - 1) + numbers(end, 5029));
    QCOMPARE(bench.queue->lost(), end - first);
}

void TestMessageQueueDamage::fullDiskStopsNothing()
{
    QueueBench bench(small(1'000'000, 100'000));
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

void TestMessageQueueDamage::folderThatCannotBeMadeStopsNothing()
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

QTEST_GUILESS_MAIN(TestMessageQueueDamage)
#include "tst_messagequeuedamage.moc"
