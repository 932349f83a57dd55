#include "core/archive/archivequery.h"
#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

DeviceRecord record(int hour, const char *data = "x")
{
    return {1, noon + hour * 1h, QStringLiteral("0123456701 %1").arg(hour), data};
}

const QString source = QStringLiteral("УСМ-ИСН 01234567");

} // namespace

/// What service windows download, through the writer into the store.
class TestRecordKeeper : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void keepsEachOnce()
    {
        ArchiveBench bench(archiveConfig(file()));
        bench.open(noon);
        bench.writer->appendRecords({1, source, {record(1), record(2)}, {}});
        bench.writer->appendRecords({1, source, {record(2, "other"), record(3)}, {}});
        bench.writer->flush();
        ArchiveQuery query(bench.config);
        QCOMPARE(query.records(1, noon, noon + 24h), (QList<DeviceRecord>{record(1), record(2), record(3)}));
        bench.writer->appendRecords({1, source, {record(1, "again"), record(4)}, {}});
        bench.close(); // without a commit in between
        QCOMPARE(query.records(1, noon, noon + 24h), (QList<DeviceRecord>{record(1), record(2), record(3), record(4)}));
    }

    /// Of the gap of an hour only what the records stand for; no other sensor's.
    void fillsGaps()
    {
        ArchiveBench bench(archiveConfig(file()));
        bench.open(noon);
        bench.read(1, noon + 1s, 5);
        bench.read(2, noon + 1s, 5);
        bench.close();
        bench.open(noon + 1h);
        bench.read(1, noon + 1h + 1s, 5);
        bench.read(2, noon + 1h + 1s, 5);
        bench.writer->flush();
        bench.writer->appendRecords({1, source, {record(0)}, {{noon + 10min, noon + 50min}}});
        bench.writer->flush();
        ArchiveQuery query(bench.config);
        const GapReason reason = GapReason::ProgramStopped;
        const QList<Gap> expected{
            {1, noon + 1s, noon + 10min, reason, {}},
            {1, noon + 10min, noon + 50min, reason, source},
            {1, noon + 50min, noon + 1h + 1s, reason, {}}};
        QCOMPARE(query.gaps({1}, noon, noon + 2h), expected);
        QCOMPARE(query.gaps({2}, noon, noon + 2h).size(), 1);
        bench.writer->appendRecords({1, QStringLiteral("another"), {}, {{noon + 10min, noon + 50min}}});
        bench.close();
        QCOMPARE(query.gaps({1}, noon, noon + 2h), expected); // what is filled keeps its source
    }

    /// The one who follows a gap that goes on writes it again when it ends.
    void leavesAGapThatGoesOn()
    {
        ArchiveStore store(archiveConfig(file()));
        QVERIFY(store.database().open());
        const Gap open{1, noon, {}, GapReason::NoAnswer, {}};
        QVERIFY(store.putGap(open));
        RecordKeeper keeper;
        keeper.put({1, source, {}, {{noon + 10min, noon + 50min}}});
        QVERIFY(keeper.write(store));
        ArchiveQuery query(archiveConfig(file()));
        QCOMPARE(query.gaps({1}, noon, noon + 2h), QList<Gap>{open});
    }

    /// Nothing waits for ever, and nothing waits without a limit.
    void waitsForTheStore()
    {
        RecordKeeper keeper;
        ArchiveStore store(archiveConfig(file()));
        keeper.put({1, source, {record(1), record(2)}, {}});
        QVERIFY(!keeper.write(store)); // it is closed
        QCOMPARE(keeper.waiting(), 2);
        QVERIFY(store.database().open());
        QVERIFY(keeper.write(store));
        QCOMPARE(keeper.waiting(), 0);
        ArchiveQuery query(archiveConfig(file()));
        QCOMPARE(query.records(1, noon, noon + 24h).size(), 2);
        keeper.put({1, source, QList<DeviceRecord>(RecordKeeper::mostRecords + 1, record(1)), {}});
        QCOMPARE(keeper.waiting(), 0);
    }

    void saysWhatIsLost()
    {
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("deep/archive.sqlite"))); // no file can be there
        ArchiveBench bench(archiveConfig(file()));
        bench.open(noon);
        QStringList texts;
        connect(bench.writer.get(), &ArchiveWriter::journal, this, [&texts](const JournalEntry &entry) {
            texts += entry.text;
        });
        bench.writer->appendRecords({1, source, {record(1), record(2)}, {}});
        bench.close();
        QVERIFY2(
            texts.contains(QStringLiteral("2 records of devices are not in the archive. Download all of them again.")),
            qPrintable(texts.join(u'\n')));
    }

private:
    QString file() const { return m_folder->filePath(QStringLiteral("deep/archive.sqlite")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestRecordKeeper)
#include "tst_recordkeeper.moc"
