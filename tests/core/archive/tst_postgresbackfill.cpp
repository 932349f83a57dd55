#include "tests/core/archive/archivesite.h"
#include "tests/core/archive/postgresserver.h"

#include <QFileInfo>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What comes late to an archive on a server, while the server is there and while it is away.
class TestPostgresBackfill : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void goesThroughTheSpool_data();
    void goesThroughTheSpool();
    void cutsLongNames();

private:
    std::unique_ptr<PostgresServer> m_server;
};

void TestPostgresBackfill::initTestCase()
{
    if (const QString reason = PostgresServer::whyNot(); !reason.isEmpty()) {
        QVERIFY2(!qEnvironmentVariableIsSet("GORIZONT_REQUIRE_POSTGRESQL"), qPrintable(reason));
        QSKIP(qPrintable(reason));
    }
    m_server = std::make_unique<PostgresServer>();
    QVERIFY2(m_server->create(), qPrintable(m_server->error()));
}

void TestPostgresBackfill::goesThroughTheSpool_data()
{
    QTest::addColumn<bool>("isAway");
    QTest::addColumn<bool>("isKilled");
    QTest::newRow("the server is there") << false << false;
    QTest::newRow("it is away") << true << false;
    QTest::newRow("and the program is killed") << true << true;
}

void TestPostgresBackfill::goesThroughTheSpool()
{
    QFETCH(bool, isAway);
    QFETCH(bool, isKilled);
    const QTemporaryDir folder;
    const QString site = QStringLiteral("site_%1_%2").arg(isAway).arg(isKilled);
    ArchiveBench bench(m_server->config(site, folder.filePath(QStringLiteral("archive.sqlite"))));
    bench.open(noon);
    bench.read(1, noon, 5);
    bench.close();
    bench.open(noon + 10h);
    bench.read(1, noon + 10h, 6);
    bench.writer->flush();
    if (isAway) {
        m_server->stop();
    }
    const QString memory = QStringLiteral("память 12345678");
    const QList<DeviceRecord> records{
        {1, noon + 1h, QStringLiteral("X 1"), "a"}, {1, noon + 2h, QStringLiteral("X 2"), QByteArray("\0'", 2)}};
    for (int round = 0; round < 2; ++round) {
        bench.writer->appendRecords(
            {1, memory, records, {tiltReading(1, noon + 1h, 11), tiltReading(1, noon + 2h, 12)}});
        bench.now += 1s;
        bench.writer->flush();
    }
    if (isAway) {
        if (isKilled) {
            bench.writer.reset();
            bench.open(noon + 10h + 3s);
        }
        QVERIFY2(m_server->start(), qPrintable(m_server->error()));
    }
    const QFileInfo spool(folder.filePath(QStringLiteral("archive.spool")));
    for (int i = 0; i < 100 && (i < 3 || QFileInfo(spool.filePath()).size() > 0); ++i) {
        bench.now += 1s;
        bench.read(1, bench.now, 7);
        bench.writer->flush();
    }
    bench.close();
    ArchiveQuery query(bench.config);
    QCOMPARE(query.records(1, noon, noon + 9h), records);
    const QList<Gap> expected{
        {1, noon, noon + 3h, GapReason::ProgramStopped, memory},
        {1, noon + 3h, noon + 10h, GapReason::ProgramStopped, {}}};
    QCOMPARE(query.gaps({1}, noon - 1h, noon + 9h), expected);
    QCOMPARE(bench.fullRate({1, Quantity::TiltX}, noon + 1min, noon + 9h).size(), 2);
}

/// A name that the server would refuse must not stop the archive.
void TestPostgresBackfill::cutsLongNames()
{
    const QTemporaryDir folder;
    ArchiveBench bench(m_server->config(QStringLiteral("long"), folder.filePath(QStringLiteral("archive.sqlite"))));
    bench.open(noon);
    bench.now = noon + 10h;
    bench.writer->appendRecords(
        {1, QString(200, u's'), {{1, noon, QString(200, u'n'), "a"}}, {tiltReading(1, noon + 1h, 1)}});
    bench.close();
    ArchiveQuery query(bench.config);
    QCOMPARE(query.records(1, noon, noon + 1h).value(0).name, QString(64, u'n'));
    QCOMPARE(query.gaps({1}, noon + 1h, noon + 1h + 1s).value(0).filledFrom, QString(64, u's'));
    QCOMPARE(bench.sentences, QStringList());
}

QTEST_GUILESS_MAIN(TestPostgresBackfill)

#include "tst_postgresbackfill.moc"
