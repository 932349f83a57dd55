#include "core/archive/archivereader.h"
#include "tests/core/archive/archivesite.h"

#include <QRandomGenerator>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What cannot be read is not taken for nothing.
class TestArchiveFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void aTailThatEndsInAnErrorIsNotATail();
    void rowsBehindTheErrorAreNotRemoved();
    void aDamagedPageIsNoAnswer();
    void aFileOfAnotherKindIsNoAnswer();
    void noArchiveIsAnEmptyAnswer();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite")); }
    void damagePageWith(const QByteArray &mark);

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestArchiveFaults::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

/// The page in which \a mark stands becomes one that SQLite does not know.
void TestArchiveFaults::damagePageWith(const QByteArray &mark)
{
    constexpr qint64 pageSize = 16384;
    QFile opened(file());
    QVERIFY(opened.open(QIODevice::ReadWrite));
    const qint64 at = opened.readAll().indexOf(mark);
    QVERIFY(at > pageSize);
    QVERIFY(opened.seek(at / pageSize * pageSize) && opened.write(QByteArray(pageSize, '\xAA')) == pageSize);
}

void TestArchiveFaults::aTailThatEndsInAnErrorIsNotATail()
{
    ArchiveStore store(archiveConfig(file()));
    QVERIFY(store.database().open());
    for (int row = 0; row < 100; ++row) {
        QVERIFY(store.appendTail(QByteArray(5000, 'x') + "row " + QByteArray::number(row) + '.'));
    }
    QCOMPARE(store.tail().value().size(), 100);
    store.database().close();
    damagePageWith("row 70.");
    QVERIFY(store.database().open());
    QVERIFY(!store.tail());
    QCOMPARE(store.database().fault(), ArchiveFault::Damaged);
    QVERIFY2(store.database().error().endsWith(u"is damaged."), qPrintable(store.database().error()));
}

/// The file is set aside whole, and what stands behind the damage is in the next one.
void TestArchiveFaults::rowsBehindTheErrorAreNotRemoved()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    QByteArray before;
    QRandomGenerator random(1);
    for (int second = 1; second <= 500; ++second) {
        bench.read(1, noon + second * 1s, second);
        if (second % 5 == 0) {
            SampleBlock noise = sampleBlock(noon + second * 1s, 0, 2000, false);
            for (qint16 &sample : noise.x) {
                sample = static_cast<qint16>(random.bounded(65'536) - 32'768); // a row is half a page
            }
            bench.writer->appendBlock(noise);
            bench.writer->flush();
        }
    }
    bench.close();
    {
        ArchiveDatabase database(bench.config, ArchiveDatabase::Access::Salvage);
        QVERIFY(database.open());
        before = database.single(QStringLiteral("SELECT data FROM tail ORDER BY id LIMIT 1 OFFSET 50")).toByteArray();
    }
    QVERIFY(before.size() > 100);
    damagePageWith(before.first(40));
    bench.open(noon + 600s);
    for (int i = 0; i < 50; ++i) {
        bench.read(1, noon + (600 + i) * 1s, i);
        bench.writer->flush();
    }
    bench.close();
    QVERIFY2(bench.sentences.value(0).contains(u"is damaged"), qPrintable(bench.sentences.join(u'\n')));
    const Buckets kept = bench.fullRate({1, Quantity::TiltX}, noon + 1s, noon + 501s);
    QVERIFY2(kept.size() >= 400 && kept.size() < 500, qPrintable(QString::number(kept.size())));
    QVERIFY(kept.last().from == noon + 500s);
}

void TestArchiveFaults::aDamagedPageIsNoAnswer()
{
    {
        ArchiveStore store(archiveConfig(file()));
        QVERIFY(store.database().open());
        for (int i = 0; i < 100; ++i) {
            const TimeSpan span{noon + i * 60s, noon + (i + 1) * 60s};
            QVERIFY(
                store.appendChunk(ChunkKind::FullRate, 1, span, QByteArray(5000, 'x') + QByteArray::number(i) + '.'));
            QVERIFY(store.putGap({1, span.from, span.to, GapReason::Crc, {}}));
        }
    }
    ArchiveReader reader(archiveConfig(file()));
    const SeriesQuery query{{{1, Quantity::TiltX}}, noon, noon + 2h, 0};
    QVERIFY(!reader.series(query).isCanceled());
    reader.reopen();
    damagePageWith("x70.");
    QFuture<QList<Series>> series = reader.series(query);
    series.waitForFinished();
    QVERIFY(series.isCanceled());
    QCOMPARE(series.resultCount(), 0);
    QCOMPARE(reader.gaps({1}, noon, noon + 2h).result().size(), 100); // the failure was of the question before
}

void TestArchiveFaults::aFileOfAnotherKindIsNoAnswer()
{
    QFile other(file());
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(QByteArray("this is a letter to my aunt\n").repeated(1000));
    other.close();
    ArchiveReader reader(archiveConfig(file()));
    const auto isRefused = [](auto answer) {
        answer.waitForFinished();
        return answer.isCanceled() && answer.resultCount() == 0;
    };
    QVERIFY(isRefused(reader.series({{{1, Quantity::TiltX}}, noon, noon + 1h, 0})));
    QVERIFY(isRefused(reader.gaps({1}, noon, noon + 1h)));
    QVERIFY(isRefused(reader.completeness({1}, {2024, 12, 31}, {2024, 12, 31})));
    QVERIFY(isRefused(reader.events(noon, noon + 1h, 5)));
    QVERIFY(isRefused(reader.blocks(3, noon, noon + 1h)));
    QVERIFY(isRefused(reader.records(1, noon, noon + 1h)));
}

/// Neither a file that is not there, nor one into which nothing was written.
void TestArchiveFaults::noArchiveIsAnEmptyAnswer()
{
    ArchiveReader reader(archiveConfig(file()));
    QCOMPARE(reader.events(noon, noon + 1h, 5).result(), QList<JournalEntry>());
    QCOMPARE(reader.records(1, noon, noon + 1h).result().size(), 0);
    QFile empty(file());
    QVERIFY(empty.open(QIODevice::WriteOnly));
    empty.close();
    QCOMPARE(reader.gaps({1}, noon, noon + 1h).result(), QList<Gap>());
    QCOMPARE(reader.series({{{1, Quantity::TiltX}}, noon, noon + 1h, 0}).result().size(), 1);
}

QTEST_GUILESS_MAIN(TestArchiveFaults)

#include "tst_archivefaults.moc"
