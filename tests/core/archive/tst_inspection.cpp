#include "core/archive/inspection.h"
#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

class TestInspection : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void countsWhatIsThere();
    void findsDamagedRows();
    void copiesWhileItIsWritten();
    void overwritesNothing();
    void explainsWhatIsMissing();

private:
    QString file(const char *name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    void write(ArchiveBench &bench, int first, int last);

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_error;
};

void TestInspection::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_error.clear();
}

void TestInspection::write(ArchiveBench &bench, int first, int last)
{
    for (int second = first; second <= last; ++second) {
        bench.read(1, noon + second * 1s, second);
    }
    bench.writer->flush();
}

void TestInspection::countsWhatIsThere()
{
    ArchiveBench bench(archiveConfig(file("a")));
    bench.open(noon);
    write(bench, 1, 600);
    write(bench, 601, 650);
    bench.writer->appendJournal({JournalKind::Info, noon, QStringLiteral("x"), 0, 0});
    bench.writer->flush();
    const auto report = inspectArchive(bench.config, &m_error);
    QVERIFY2(report && report->isGood(), qPrintable(m_error));
    QCOMPARE(report->chunks, 1);
    QCOMPARE(report->readings, 600);
    QCOMPARE(report->rollups, 2 * 3);
    QCOMPARE(report->commits, 1);
    QCOMPARE(report->events, 1);
    QVERIFY(report->bytes > 16384);
    QCOMPARE(countArchive(bench.config, &m_error)->rollups, 6);
}

void TestInspection::findsDamagedRows()
{
    ArchiveBench bench(archiveConfig(file("a")));
    bench.open(noon);
    write(bench, 1, 600);
    ArchiveDatabase database(bench.config, ArchiveDatabase::Access::Write);
    QVERIFY(database.open());
    QVERIFY(database.execute(QStringLiteral("UPDATE chunk SET data = x'0101ff'")));
    QVERIFY(database.execute(QStringLiteral("UPDATE rollup SET data = x'00' WHERE kind = 4 AND quantity = 1")));
    const auto report = inspectArchive(bench.config, &m_error);
    QVERIFY(report && !report->isGood());
    QCOMPARE(report->damaged, 2);
    QCOMPARE(report->readings, 0);
}

void TestInspection::copiesWhileItIsWritten()
{
    ArchiveBench bench(archiveConfig(file("a")));
    bench.open(noon);
    write(bench, 1, 700);
    QVERIFY2(backUpArchive(bench.config, file("copy"), &m_error), qPrintable(m_error));
    write(bench, 701, 800);
    const ArchiveBench copy(archiveConfig(file("copy")));
    QCOMPARE(copy.fullRate({1, Quantity::TiltX}, noon, noon + 1h).size(), 700);
    QCOMPARE(bench.fullRate({1, Quantity::TiltX}, noon, noon + 1h).size(), 800);
    QVERIFY(inspectArchive(copy.config, &m_error)->isGood());
    QVERIFY(bench.sentences.isEmpty());
}

void TestInspection::overwritesNothing()
{
    ArchiveBench bench(archiveConfig(file("a")));
    bench.open(noon);
    QFile other(file("other"));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("precious") == 8);
    other.close();
    QVERIFY(!backUpArchive(bench.config, file("other"), &m_error));
    QVERIFY(m_error.contains(QStringLiteral("is there already")));
    QCOMPARE(other.size(), 8);
    QVERIFY(!backUpArchive(bench.config, file("no/such/folder"), &m_error));
    QVERIFY(!m_error.isEmpty());
}

void TestInspection::explainsWhatIsMissing()
{
    QVERIFY(!inspectArchive(archiveConfig(file("none")), &m_error));
    QVERIFY(m_error.contains(QStringLiteral("There is no archive")));
    QVERIFY(!QFile::exists(file("none")));
    QFile letter(file("letter"));
    QVERIFY(letter.open(QIODevice::WriteOnly) && letter.write(QByteArray(5000, 'x')) == 5000);
    letter.close();
    QVERIFY(!inspectArchive(archiveConfig(file("letter")), &m_error));
    QVERIFY2(m_error.contains(QStringLiteral("is damaged")), qPrintable(m_error));
}

QTEST_GUILESS_MAIN(TestInspection)

#include "tst_inspection.moc"
