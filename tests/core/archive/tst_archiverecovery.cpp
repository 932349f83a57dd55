#include "core/archive/readingchunk.h"
#include "tests/core/archive/archivesite.h"
#include "tests/core/archive/failingdisk.h"

#include <QElapsedTimer>
#include <QRegularExpression>
#include <QSemaphore>
#include <QTest>

#include <thread>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};

/// Nobody else can open \a config's archive while it lives, at most for \a atMost.
class Holder
{
public:
    Holder(const ArchiveConfig &config, std::chrono::milliseconds atMost)
        : m_thread([this, config, atMost] {
            ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
            m_isHeld = database.open() && database.execute(QStringLiteral("PRAGMA locking_mode=EXCLUSIVE"))
                && database.execute(QStringLiteral("BEGIN IMMEDIATE"));
            m_started.release();
            m_ended.tryAcquire(1, static_cast<int>(atMost.count()));
        })
    {
        m_started.acquire();
    }
    ~Holder()
    {
        m_ended.release();
        m_thread.join();
    }
    Q_DISABLE_COPY_MOVE(Holder)
    bool isHeld() const { return m_isHeld; }

private:
    QSemaphore m_started;
    QSemaphore m_ended;
    bool m_isHeld = false;
    std::thread m_thread;
};

} // namespace

/// The way back to an archive that is written.
class TestArchiveRecovery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void waitingForTheStoreIsNoClockStep();
    void aSweepThatFailsIsTold();
    void sweepsWhileTheDiskIsFull();
    void takesOverAfterAKill_data();
    void takesOverAfterAKill();
    void whatIsAtHandSurvivesDamageAtTheEnd();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite")); }
    bool execute(const ArchiveConfig &config, const QString &sql) const
    {
        ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
        return database.open() && database.execute(sql);
    }

    int count(const ArchiveConfig &config, const QString &rows) const
    {
        ArchiveDatabase database(config, ArchiveDatabase::Access::Read);
        return database.open() ? database.single(QStringLiteral("SELECT count(*) FROM ") + rows).toInt() : -1;
    }
    void fillAndDamage(const ArchiveConfig &config);

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestArchiveRecovery::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestArchiveRecovery::waitingForTheStoreIsNoClockStep()
{
    const ArchiveConfig config = archiveConfig(file());
    ArchiveWriter writer(config);
    const auto read = [&writer] {
        writer.updateReadings({tiltReading(1, utcNow(), 5)});
        writer.flush();
    };
    const UtcTime start = utcNow();
    read();
    QVERIFY(execute(config, QStringLiteral("ALTER TABLE rollup RENAME TO elsewhere")));
    for (int i = 1; i <= 600; ++i) {
        writer.updateReadings({tiltReading(1, start - 600us + i * 1us, i)});
    }
    writer.flush(); // its chunk fails, which closes the store; nothing else waits
    QVERIFY(execute(config, QStringLiteral("ALTER TABLE elsewhere RENAME TO rollup")));
    QElapsedTimer timer;
    {
        const Holder holder(config, 1400ms);
        QVERIFY(holder.isHeld());
        timer.start();
        read();
        QVERIFY2(timer.elapsed() > 1100, qPrintable(QString::number(timer.elapsed())));
    }
    read();
    read();
    writer.stop();
    ArchiveQuery query(config);
    const UtcTime end = utcNow() + 1s;
    QCOMPARE(query.series({{tiltX}, start - 1s, end, 0}).value(0).buckets.size(), 604);
    for (const Gap &gap : query.gaps({1}, start - 1s, end)) {
        QVERIFY(gap.reason != GapReason::Clock);
    }
}

/// The table of rollups is touched by the sweep and not by the commits.
void TestArchiveRecovery::aSweepThatFailsIsTold()
{
    ArchiveConfig config = archiveConfig(file());
    config.retention.rollups = 24h;
    config.retentionInterval = 0ms;
    ArchiveBench bench(config);
    bench.open(noon);
    const auto flush = [&bench](int second) {
        bench.read(1, noon + second * 1s, second);
        bench.writer->flush();
    };
    flush(1);
    QVERIFY(execute(config, QStringLiteral("ALTER TABLE rollup RENAME TO elsewhere")));
    flush(2);
    flush(3);
    QCOMPARE(bench.sentences.size(), 1);
    QVERIFY2(
        bench.sentences.first().startsWith(u"What is too old cannot be removed from the archive: "),
        qPrintable(bench.sentences.first()));
    QVERIFY(execute(config, QStringLiteral("ALTER TABLE elsewhere RENAME TO rollup")));
    flush(4);
    flush(5);
    QCOMPARE(bench.sentences.size(), 2);
    QCOMPARE(bench.sentences.last(), QStringLiteral("What is too old is removed from the archive again."));
    bench.close();
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 1h).size(), 5);
}

/// The next regular sweep is not due yet.
void TestArchiveRecovery::sweepsWhileTheDiskIsFull()
{
    ArchiveConfig config = archiveConfig(file());
    config.retention.readings = 24h;
    ArchiveBench bench(config);
    bench.open(noon);
    for (int second = 1; second <= 1400; ++second) {
        bench.read(1, noon + second * 1s, second);
        if (second % 100 == 0) {
            bench.writer->flush();
        }
    }
    QCOMPARE(count(config, QStringLiteral("chunk")), 2);
    bench.read(1, noon + 72h, 1);
    {
        const FailingDisk disk(DiskCall::Write, 1);
        bench.writer->flush();
        QVERIFY(disk.hasFailed());
    }
    QVERIFY2(bench.sentences.value(0).contains(u"no room left"), qPrintable(bench.sentences.join(u'\n')));
    QCOMPARE(count(config, QStringLiteral("chunk")), 0);
    bench.writer->flush();
    QCOMPARE(bench.sentences.size(), 2);
    bench.close();
}

/// 1000 chunks of ten readings, 1000 events and as many hundred rows of a tail, of which one page is noise.
void TestArchiveRecovery::fillAndDamage(const ArchiveConfig &config)
{
    ArchiveStore store(config);
    QVERIFY(store.database().open() && store.database().begin());
    QVERIFY(store.putSensor(1, {noon, noon + 1000min, 0, 0}) && store.setAlive(noon + 1000min));
    for (int i = 0; i < 1000; ++i) {
        ReadingChunk chunk;
        for (int k = 0; k < 10; ++k) {
            chunk.append({1, noon + i * 1min + k * 1s, {{Quantity::TiltX, i + k / 16.0}}});
        }
        QVERIFY(store.appendChunk(ChunkKind::FullRate, 1, spanOf(chunk), encodeChunk(chunk)));
        QVERIFY(store.appendEvent({JournalKind::Info, noon + i * 1min, QString::number(i), 0, 0}));
    }
    for (int i = 0; i < 100; ++i) {
        QVERIFY(store.appendTail(QByteArray(5000, 'x') + "row " + QByteArray::number(i) + '.'));
    }
    QVERIFY(store.database().commit());
    store.database().close();
    QFile opened(config.file);
    QVERIFY(opened.open(QIODevice::ReadWrite));
    const qint64 at = opened.readAll().indexOf("row 50.") / 16384 * 16384;
    QVERIFY(at > 0 && opened.seek(at) && opened.write(QByteArray(16384, '\xAA')) == 16384);
}

void TestArchiveRecovery::takesOverAfterAKill_data()
{
    QTest::addColumn<QList<int>>("killsAfter"); // commits
    QTest::newRow("never") << QList<int>{};
    QTest::newRow("before the new file") << QList<int>{1};
    QTest::newRow("at the beginning") << QList<int>{2};
    QTest::newRow("again and again") << QList<int>{2, 1, 2, 1};
}

/// Every row once, wherever the program was killed.
void TestArchiveRecovery::takesOverAfterAKill()
{
    QFETCH(QList<int>, killsAfter);
    ArchiveConfig config = archiveConfig(file());
    config.commitInterval = 4ms; // so that each commit takes over a few rows only
    fillAndDamage(config);
    ArchiveBench bench(config);
    UtcTime at = noon + 2000min;
    bench.open(at); // sets the file aside
    const auto isDone = [&bench] { return !bench.sentences.filter(QStringLiteral("What could be read")).isEmpty(); };
    for (const int commits : killsAfter) {
        for (int i = 1; i < commits; ++i) {
            bench.writer->flush();
        }
        QVERIFY(!isDone());
        bench.writer.reset();
        at += 1min;
        bench.open(at);
    }
    for (int i = 0; i < 1000 && !isDone(); ++i) {
        bench.writer->flush();
    }
    QVERIFY2(isDone(), qPrintable(bench.sentences.join(u'\n')));
    QCOMPARE(bench.sentences.filter(QStringLiteral("was set aside")).size(), 1);
    static const QRegularExpression number(QStringLiteral("new one: (\\d+) rows"));
    const int rescued = number.match(bench.sentences.last()).captured(1).toInt();
    QVERIFY2(rescued > 2090 && rescued < 2100, qPrintable(bench.sentences.last())); // a page of the tail is missing
    bench.close();
    const Buckets all = bench.fullRate(tiltX, noon, noon + 1000min);
    QCOMPARE(all.size(), 10'000);
    QVERIFY(
        std::adjacent_find(all.begin(), all.end(), [](const auto &a, const auto &b) { return a.from == b.from; })
        == all.end());
    QCOMPARE(count(config, QStringLiteral("event")), 1000);
    QCOMPARE(count(config, QStringLiteral("meta WHERE name LIKE 'salvage%'")), 0);
    bench.open(at + 1min);
    bench.writer->flush();
    bench.close();
    QCOMPARE(count(config, QStringLiteral("event")), 1000);
}

/// The tables become unreadable between the last commit and stop().
void TestArchiveRecovery::whatIsAtHandSurvivesDamageAtTheEnd()
{
    const ArchiveConfig config = archiveConfig(file());
    ArchiveBench bench(config);
    bench.open(noon);
    for (int second = 1; second <= 200; ++second) {
        bench.read(1, noon + second * 1s, second);
        bench.writer->flush();
    }
    {
        ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
        QVERIFY(database.open() && database.execute(QStringLiteral("PRAGMA writable_schema=ON")));
        QVERIFY(database.execute(QStringLiteral("UPDATE sqlite_master SET rootpage=99999 WHERE name='tail'")));
        QVERIFY(database.execute(QStringLiteral("PRAGMA schema_version=4711")));
    }
    bench.read(1, noon + 201s, 201);
    bench.close();
    QVERIFY2(bench.sentences.value(0).contains(u"was set aside"), qPrintable(bench.sentences.join(u'\n')));
    const Buckets all = bench.fullRate(tiltX, noon, noon + 1h);
    QCOMPARE(all.size(), 201);
    QVERIFY(all.last().from == noon + 201s);
}

QTEST_GUILESS_MAIN(TestArchiveRecovery)

#include "tst_archiverecovery.moc"
