#include "tests/core/archive/archivesite.h"
#include "tests/core/archive/failingdisk.h"

#include <QDir>
#include <QRandomGenerator>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};
constexpr int seconds = 1400; ///< two chunks and a tail

/// Seconds after noon of what the archive has, in its order.
QList<int> secondsOf(const Buckets &buckets)
{
    QList<int> list;
    for (const SeriesBucket &bucket : buckets) {
        list.append(static_cast<int>((bucket.from - noon) / 1s));
    }
    return list;
}

QList<int> upTo(int last)
{
    QList<int> list;
    for (int second = 1; second <= last; ++second) {
        list.append(second);
    }
    return list;
}

const QString memory = QStringLiteral("memory of 12345678");

QList<DeviceRecord> remembered()
{
    return {{2, noon - 2h, QStringLiteral("X 1"), "1"}, {2, noon - 1h, QStringLiteral("X 2"), "2"}};
}

QList<Reading> rememberedReadings()
{
    return {tiltReading(2, noon - 2h, 1), tiltReading(2, noon - 1h, 2)};
}

/// A reading a second from \a first to \a last, a commit every \a perCommit.
void record(ArchiveBench &bench, int first, int last, int perCommit)
{
    for (int second = first; second <= last; ++second) {
        bench.read(1, noon + second * 1s, second);
        if (second % perCommit == 0) {
            bench.writer->flush();
        }
    }
    bench.writer->flush();
}

} // namespace

class TestArchiveDamage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void everyCallMayFail_data();
    void everyCallMayFail();
    void everyCallMayFailAtDamage_data();
    void everyCallMayFailAtDamage();
    void fullDiskIsAnEvent();
    void aFileOfAnotherKindIsSetAside();
    void whatIsReadableIsSalvaged_data();
    void whatIsReadableIsSalvaged();
    void everyTruncationIsSurvived();
    void everyTruncationOfTheLogIsSurvived();
    void aLockedFileIsExplained();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite")); }
    void overwrite(qint64 at, const QByteArray &bytes);
    void writeALetter();

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestArchiveDamage::init()
{
    fillDisk(false);
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestArchiveDamage::overwrite(qint64 at, const QByteArray &bytes)
{
    QFile opened(file());
    QVERIFY(opened.open(QIODevice::ReadWrite) && opened.seek(at) && opened.write(bytes) == bytes.size());
}

void TestArchiveDamage::writeALetter()
{
    QFile other(file());
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(QByteArray("this is a letter to my aunt\n").repeated(1000));
}

void TestArchiveDamage::everyCallMayFail_data()
{
    QTest::addColumn<DiskCall>("call");
    QTest::newRow("write") << DiskCall::Write;
    QTest::newRow("fsync") << DiskCall::Sync;
    QTest::newRow("open") << DiskCall::Open;
    QTest::newRow("truncate") << DiskCall::Truncate;
}

/// Whichever call fails, everything is in the archive, once, as soon as the disk works again.
void TestArchiveDamage::everyCallMayFail()
{
    QFETCH(DiskCall, call);
    bool hasFailed = true;
    int failures = 0;
    for (int nth = 1; hasFailed; ++nth) {
        init();
        ArchiveBench bench(archiveConfig(file()));
        {
            const FailingDisk disk(call, nth);
            bench.open(noon);
            record(bench, 1, 300, 100);
            bench.writer->appendRecords({2, memory, remembered(), rememberedReadings()});
            record(bench, 301, 600, 100);
            hasFailed = disk.hasFailed();
            failures += hasFailed ? 1 : 0;
        }
        record(bench, 601, 700, 50);
        bench.close();
        const QList<int> kept = secondsOf(bench.fullRate(tiltX, noon, noon + 1h));
        QVERIFY2(kept == upTo(700), qPrintable(QStringLiteral("call %1: %2").arg(nth).arg(kept.size())));
        quint32 count = 0;
        for (const SeriesBucket &bucket : bench.ask(tiltX, noon, noon + 12min, 12).buckets) {
            count += bucket.count;
        }
        QCOMPARE(count, 700U);
        ArchiveQuery query(bench.config);
        QCOMPARE(query.records(2, noon - 24h, noon), remembered());
        const QList<Gap> gaps = query.gaps({2}, noon - 24h, noon - 1min);
        QVERIFY(gaps.size() == 1 && gaps.first().from == noon - 2h && gaps.first().to >= noon);
        QCOMPARE(gaps.first().filledFrom, memory);
        QCOMPARE(bench.fullRate({2, Quantity::TiltX}, noon - 24h, noon + 24h).size(), 2);
    }
    QVERIFY(failures > (call == DiskCall::Truncate ? -1 : 3)); // the log is not cut in each version of SQLite
}

void TestArchiveDamage::everyCallMayFailAtDamage_data()
{
    everyCallMayFail_data();
    QTest::newRow("rename") << DiskCall::Rename;
}

/// Also while a file is set aside, which is lost in no case.
void TestArchiveDamage::everyCallMayFailAtDamage()
{
    QFETCH(DiskCall, call);
    bool hasFailed = true;
    int failures = 0;
    for (int nth = 1; hasFailed; ++nth) {
        init();
        writeALetter();
        ArchiveBench bench(archiveConfig(file()));
        {
            const FailingDisk disk(call, nth);
            bench.open(noon);
            record(bench, 1, 600, 200);
            hasFailed = disk.hasFailed();
            failures += hasFailed ? 1 : 0;
        }
        record(bench, 601, 700, 50);
        bench.close();
        const QList<int> kept = secondsOf(bench.fullRate(tiltX, noon, noon + 1h));
        QVERIFY2(kept == upTo(700), qPrintable(QStringLiteral("call %1: %2").arg(nth).arg(kept.size())));
        const QFileInfoList aside = QDir(m_folder->path()).entryInfoList({QStringLiteral("*.damaged-*")}, QDir::Files);
        QVERIFY2(aside.size() == 1, qPrintable(QStringLiteral("call %1: %2").arg(nth).arg(aside.size())));
        QCOMPARE(aside.first().size(), 28'000);
    }
    QVERIFY(failures > (call == DiskCall::Truncate ? -1 : call == DiskCall::Rename ? 0 : 3));
}

void TestArchiveDamage::fullDiskIsAnEvent()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    record(bench, 1, 300, 100);
    fillDisk(true);
    record(bench, 301, 900, 10);
    QCOMPARE(bench.sentences.size(), 1);
    QVERIFY2(bench.sentences.first().contains(QStringLiteral("no room left")), qPrintable(bench.sentences.first()));
    fillDisk(false);
    record(bench, 901, 1000, 10);
    QCOMPARE(bench.sentences.size(), 2);
    QCOMPARE(bench.sentences.last(), QStringLiteral("The archive is being written again."));
    bench.close();
    QCOMPARE(secondsOf(bench.fullRate(tiltX, noon, noon + 1h)), upTo(1000));
}

void TestArchiveDamage::aFileOfAnotherKindIsSetAside()
{
    writeALetter();
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    record(bench, 1, 10, 1);
    bench.close();
    QCOMPARE(secondsOf(bench.fullRate(tiltX, noon, noon + 1h)), upTo(10));
    const QStringList aside = QDir(m_folder->path()).entryList({QStringLiteral("*.damaged-*")}, QDir::Files);
    QCOMPARE(aside, QStringList{QStringLiteral("archive.sqlite.damaged-20241231-120000")});
    QVERIFY2(bench.sentences.first().contains(aside.first()), qPrintable(bench.sentences.join(u'\n')));
    QVERIFY(QFile(m_folder->filePath(aside.first())).size() == 28'000);
}

void TestArchiveDamage::whatIsReadableIsSalvaged_data()
{
    QTest::addColumn<bool>("isRunning");
    QTest::newRow("at the start") << false;
    QTest::newRow("while it is written") << true;
}

/// A page in the middle is full of noise.
void TestArchiveDamage::whatIsReadableIsSalvaged()
{
    QFETCH(bool, isRunning);
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    record(bench, 1, 30 * 600, 600);
    bench.writer->appendJournal({JournalKind::Info, noon + 5s, QStringLiteral("seen before"), 0, 0});
    bench.close();
    const Buckets whole = bench.fullRate(tiltX, noon, noon + 24h);
    QCOMPARE(whole.size(), 18'000);
    if (isRunning) {
        bench.open(noon + 18'000s);
        record(bench, 18'001, 18'100, 100);
    }
    QRandomGenerator random(3);
    const qint64 pages = QFileInfo(file()).size() / 4096;
    for (qint64 page = pages * 2 / 3; page < pages * 2 / 3 + 3; ++page) {
        QByteArray noise(4096, '\0');
        for (char &byte : noise) {
            byte = static_cast<char>(random.bounded(256));
        }
        overwrite(page * 4096, noise);
    }
    if (!isRunning) {
        bench.open(noon + 18'000s);
    }
    record(bench, 18'101, 18'101 + 1300, 100); // here it comes upon the damage, if it has not yet
    for (int i = 0; i < 100; ++i) {
        bench.writer->flush();
    }
    bench.close();
    const QList<int> kept = secondsOf(bench.fullRate(tiltX, noon, noon + 24h));
    QVERIFY2(kept.size() > 10'000, qPrintable(QString::number(kept.size())));
    QCOMPARE(QSet<int>(kept.begin(), kept.end()).size(), kept.size());
    QCOMPARE(kept.last(), 18'101 + 1300);
    for (const SeriesBucket &bucket : bench.fullRate(tiltX, noon, noon + 24h)) {
        QCOMPARE(bucket.mean, static_cast<double>((bucket.from - noon) / 1s) / 256);
    }
}

/// Wherever the file ends: the program starts, says what it does, and keeps what comes.
void TestArchiveDamage::everyTruncationIsSurvived()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    record(bench, 1, 8000, 400);
    bench.close();
    QFile original(file());
    QVERIFY(original.open(QIODevice::ReadOnly));
    const QByteArray bytes = original.readAll();
    QList<qsizetype> lengths{0, 1, 99, 100, 4095, 4096};
    for (qsizetype length = bytes.size() - 1; length > bytes.size() - 4 * 4096; length -= 409) {
        lengths.append(length);
    }
    for (const qsizetype length : std::as_const(lengths)) {
        init();
        QFile cut(file());
        QVERIFY(cut.open(QIODevice::WriteOnly) && cut.write(bytes.first(length)) == length);
        cut.close();
        ArchiveBench next(archiveConfig(file()));
        next.open(noon + 8000s);
        record(next, 8001, 8700, 100);
        next.close();
        const QList<int> kept = secondsOf(next.fullRate(tiltX, noon + 8001s, noon + 24h));
        QVERIFY2(kept.size() == 700, qPrintable(QStringLiteral("%1: %2").arg(length).arg(kept.size())));
        QCOMPARE(kept.last(), 8700);
    }
}

/// A log that is torn anywhere costs the last commits, nothing before them, and nothing comes twice.
void TestArchiveDamage::everyTruncationOfTheLogIsSurvived()
{
    const QTemporaryDir other;
    const QString source = other.filePath(QStringLiteral("archive.sqlite"));
    ArchiveBench bench(archiveConfig(source));
    bench.open(noon);
    record(bench, 1, 200, 20);
    const auto bytesOf = [](const QString &path) {
        QFile opened(path);
        return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
    };
    const QByteArray main = bytesOf(source);
    const QByteArray log = bytesOf(source + QStringLiteral("-wal"));
    QVERIFY(log.size() > 4096);
    qsizetype most = 0;
    for (qsizetype length = 0; length <= log.size(); length += 777) {
        init();
        QFile mainFile(file());
        QFile logFile(file() + QStringLiteral("-wal"));
        QVERIFY(mainFile.open(QIODevice::WriteOnly) && mainFile.write(main) == main.size());
        QVERIFY(logFile.open(QIODevice::WriteOnly) && logFile.write(log.first(length)) == length);
        mainFile.close();
        logFile.close();
        ArchiveBench next(archiveConfig(file()));
        next.open(noon + 300s);
        next.close();
        const QList<int> kept = secondsOf(next.fullRate(tiltX, noon, noon + 1h));
        QCOMPARE(kept, upTo(static_cast<int>(kept.size())));
        QVERIFY(kept.size() >= most);
        most = kept.size();
    }
    QVERIFY(most >= 180);
}

void TestArchiveDamage::aLockedFileIsExplained()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.close();
    ArchiveDatabase holder(bench.config, ArchiveDatabase::Access::Write);
    QVERIFY(holder.open() && holder.execute(QStringLiteral("BEGIN IMMEDIATE")));
    bench.open(noon + 1s);
    record(bench, 2, 3, 5);
    QCOMPARE(bench.sentences.size(), 1);
    QVERIFY2(
        bench.sentences.first().contains(QStringLiteral("in use by another")), qPrintable(bench.sentences.first()));
    QVERIFY(holder.execute(QStringLiteral("ROLLBACK")));
    record(bench, 4, 5, 5);
    bench.close();
    QCOMPARE(secondsOf(bench.fullRate(tiltX, noon, noon + 1h)), (QList<int>{2, 3, 4, 5}));
}

QTEST_GUILESS_MAIN(TestArchiveDamage)

#include "tst_archivedamage.moc"
