#include "tests/core/archive/archivesite.h"
#include "tests/core/archive/postgresserver.h"

#include <QDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};
const QString again = QStringLiteral("The archive is being written again.");

int valueAt(int second)
{
    return (second * 37) % 1009 - 300;
}

/// Both stores get the same: two runs with an hour between, chunks and a tail, samples, events.
void fill(ArchiveBench &bench)
{
    bench.open(noon);
    for (int second = 1; second <= 1300; ++second) {
        const auto pause = second > 900 ? 1h : 0h;
        const UtcTime time = noon + second * 1s + pause;
        bench.read(1, time, valueAt(second));
        bench.read(2, time, -valueAt(second));
        if (second % 4 == 0) {
            bench.writer->appendBlock(sampleBlock(time, second, 32, second > 4));
        }
        if (second % 100 == 0) {
            bench.writer->appendJournal({JournalKind::On, time, QStringLiteral("Порт 'COM3' \\ \"x\""), 1, 2});
        }
        bench.writer->flush();
        if (second == 900) {
            bench.close();
            bench.open(time + 1h);
        }
    }
}

} // namespace

class TestArchivePostgres : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanupTestCase();
    void answersLikeSqlite();
    void keepsSitesApart();
    void refusesASecondWriter();
    void keepsRecordsOnce();
    void bridges_data();
    void bridges();
    void tellsTheStopWithoutTheServer();
    void writesNothingTwice();
    void remembersWhatWasNotAnswered();
    void explainsAWrongPassword();
    void asksTheServerThatIsBack();
    void boundsTheSpool();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("deep/archive.sqlite")); }
    QString spool() const { return m_folder->filePath(QStringLiteral("deep/archive.spool")); }
    /// Another schema for every test.
    ArchiveConfig config() const { return m_server->config(QStringLiteral("site_%1").arg(m_count), file()); }
    /// Until the spool is empty; the clock goes on by a second each time.
    bool settle(ArchiveBench &bench) const;

    std::unique_ptr<PostgresServer> m_server;
    std::unique_ptr<QTemporaryDir> m_folder;
    int m_count = 0;
};

void TestArchivePostgres::initTestCase()
{
    if (const QString reason = PostgresServer::whyNot(); !reason.isEmpty()) {
        QVERIFY2(!qEnvironmentVariableIsSet("GORIZONT_REQUIRE_POSTGRESQL"), qPrintable(reason));
        QSKIP(qPrintable(reason));
    }
    m_server = std::make_unique<PostgresServer>();
    QVERIFY2(m_server->create(), qPrintable(m_server->error()));
}

void TestArchivePostgres::cleanupTestCase()
{
    m_server.reset();
}

void TestArchivePostgres::init()
{
    ++m_count;
    m_folder = std::make_unique<QTemporaryDir>();
}

bool TestArchivePostgres::settle(ArchiveBench &bench) const
{
    for (int i = 0; i < 100 && QFileInfo(spool()).size() > 0; ++i) {
        bench.now += 1s;
        bench.writer->flush();
    }
    return QFileInfo(spool()).size() == 0;
}

void TestArchivePostgres::answersLikeSqlite()
{
    ArchiveBench file(archiveConfig(this->file()));
    ArchiveBench server(config());
    fill(file);
    fill(server);
    const auto compare = [&file, &server] {
        for (const SeriesKey key :
             {tiltX, SeriesKey{2, Quantity::TiltY}, SeriesKey{2, Quantity::Temperature},
              SeriesKey{3, Quantity::SampleX}}) {
            for (const int width : {0, 1000, 100, 2}) {
                const Series expected = file.ask(key, noon, noon + 3h, width);
                const Series series = server.ask(key, noon, noon + 3h, width);
                QVERIFY(!expected.buckets.isEmpty());
                QCOMPARE(series.step, expected.step);
                QCOMPARE(series.buckets, expected.buckets);
                QCOMPARE(series.gaps, expected.gaps);
            }
        }
        ArchiveQuery inFile(file.config);
        ArchiveQuery onServer(server.config);
        QCOMPARE(onServer.gaps({1, 2, 3}, noon, noon + 3h), inFile.gaps({1, 2, 3}, noon, noon + 3h));
        QVERIFY(!onServer.gaps({1}, noon, noon + 3h).isEmpty());
        const QDate day(2024, 12, 31);
        QCOMPARE(
            onServer.completeness({1, 2, 3}, day, day, QTimeZone::utc()),
            inFile.completeness({1, 2, 3}, day, day, QTimeZone::utc()));
        QCOMPARE(onServer.events(noon, noon + 3h, 100), inFile.events(noon, noon + 3h, 100));
        QCOMPARE(onServer.events(noon, noon + 3h, 100).size(), 13);
        QCOMPARE(onServer.blocks(3, noon, noon + 3h), inFile.blocks(3, noon, noon + 3h));
        QCOMPARE(onServer.blocks(3, noon, noon + 3h).size(), 325);
    };
    compare();
    file.close();
    server.close();
    compare();
    QCOMPARE(server.sentences, QStringList());
}

void TestArchivePostgres::keepsSitesApart()
{
    const QString here = QStringLiteral("site_tower \"Ø\"");
    const QString there = QStringLiteral("site_мост");
    ArchiveBench tower(m_server->config(here, m_folder->filePath(QStringLiteral("tower.sqlite"))));
    ArchiveBench bridge(m_server->config(there, m_folder->filePath(QStringLiteral("bridge.sqlite"))));
    tower.open(noon);
    bridge.open(noon);
    for (int second = 1; second <= 20; ++second) {
        tower.read(1, noon + second * 1s, second);
        tower.writer->flush();
        bridge.read(1, noon + second * 2s, -second);
        bridge.writer->flush();
    }
    const Buckets ofTower = tower.fullRate(tiltX, noon, noon + 1h);
    const Buckets ofBridge = bridge.fullRate(tiltX, noon, noon + 1h);
    QCOMPARE(ofTower.size(), 20);
    QCOMPARE(ofBridge.size(), 20);
    QCOMPARE(ofTower.at(3).mean, 4 / 256.0);
    QCOMPARE(ofBridge.at(3).mean, -4 / 256.0);
    QVERIFY(ofBridge.at(3).from == noon + 8s);
    tower.close();
    bridge.close();
    QCOMPARE(tower.sentences + bridge.sentences, QStringList());
}

void TestArchivePostgres::refusesASecondWriter()
{
    ArchiveBench first(config());
    first.open(noon);
    ArchiveBench second(m_server->config(first.config.site, m_folder->filePath(QStringLiteral("other.sqlite"))));
    second.open(noon);
    QCOMPARE(second.sentences.size(), 1);
    QVERIFY2(second.sentences.first().contains(u"is in use by another program"), qPrintable(second.sentences.first()));
    first.close();
    second.now += 1s;
    second.writer->flush();
    QCOMPARE(second.sentences.value(1), again);
    second.close();
}

void TestArchivePostgres::keepsRecordsOnce()
{
    ArchiveStore store(config());
    QVERIFY(store.database().open());
    bool isNew = false;
    const DeviceRecord record{7, noon, QStringLiteral("event 12"), QByteArray("\0\1\2'\\\xFF", 6)};
    QVERIFY(store.putRecord(record, &isNew) && isNew);
    QVERIFY(store.putRecord({7, noon, QStringLiteral("event 12"), "other"}, &isNew) && !isNew);
    ArchiveQuery query(config());
    QCOMPARE(query.records(7, noon, noon + 1s), QList<DeviceRecord>{record});
}

void TestArchivePostgres::bridges_data()
{
    QTest::addColumn<int>("stopAt");
    QTest::addColumn<bool>("isCrash");
    QTest::addColumn<QList<int>>("killsAt");
    QTest::newRow("stopped") << 100 << false << QList<int>{};
    QTest::newRow("crashed") << 100 << true << QList<int>{};
    QTest::newRow("crashed, program killed once") << 100 << true << QList<int>{150};
    QTest::newRow("stopped, program killed often") << 100 << false << QList<int>{101, 102, 170, 250, 301, 303};
    QTest::newRow("not there from the beginning") << 0 << false << QList<int>{50};
}

/// The server is away from \a stopAt to 300; a writer that is dropped without stop() is what a kill leaves behind.
void TestArchivePostgres::bridges()
{
    QFETCH(int, stopAt);
    QFETCH(bool, isCrash);
    QFETCH(QList<int>, killsAt);
    ArchiveBench bench(config());
    Buckets expected;
    const auto stopServer = [this, isCrash] { isCrash ? m_server->crash() : m_server->stop(); };
    if (stopAt == 0) {
        stopServer();
    }
    bench.open(noon);
    for (int second = 1; second <= 700; ++second) {
        const UtcTime time = noon + second * 1s;
        const double value = valueAt(second) / 256.0;
        bench.read(1, time, valueAt(second));
        bench.writer->appendJournal({JournalKind::Info, time, QString::number(second), 0, 0});
        bench.writer->appendBlock(sampleBlock(time, second, 10));
        expected.append({time, value, value, value, 1, 1});
        bench.writer->flush();
        if (second == stopAt) {
            stopServer();
        } else if (second == 300) {
            QVERIFY(QFileInfo(spool()).size() > 0);
            QVERIFY2(m_server->start(), qPrintable(m_server->error()));
        }
        if (killsAt.contains(second)) {
            bench.writer.reset();
            bench.open(time);
        }
    }
    QVERIFY(settle(bench));
    for (int pass = 0; pass < 2; ++pass) {
        QCOMPARE(bench.fullRate(tiltX, noon, noon + 3h), expected);
        QCOMPARE(bench.fullRate({3, Quantity::SampleX}, noon, noon + 3h).size(), 7000);
        QCOMPARE(bench.ask(tiltX, noon, noon + 10min, 10).buckets.at(4).count, 60U);
        const auto events = ArchiveQuery(bench.config).events(noon, noon + 3h, 2000);
        QCOMPARE(events.size(), 700);
        QCOMPARE(events.last().text, QStringLiteral("700"));
        if (pass == 0) {
            bench.close();
        }
    }
    if (killsAt.isEmpty()) {
        QCOMPARE(bench.sentences.size(), 2);
        QVERIFY2(bench.sentences.first().contains(u"does not answer"), qPrintable(bench.sentences.first()));
        QVERIFY(bench.sentences.first().contains(QDir::toNativeSeparators(spool())));
        QCOMPARE(bench.sentences.last(), again);
    }
    QCOMPARE(bench.sentences.count(again), 1);
}

/// It was stopped while the server was there, killed while it was not, and began again each time.
void TestArchivePostgres::tellsTheStopWithoutTheServer()
{
    ArchiveBench bench(config());
    bench.open(noon);
    bench.read(1, noon + 1s, 5);
    bench.close();
    m_server->stop();
    bench.open(noon + 1h);
    for (int second = 0; second <= 20; ++second) {
        bench.read(1, noon + 1h + second * 1s, second);
        bench.writer->flush();
    }
    bench.writer.reset();
    QVERIFY2(m_server->start(), qPrintable(m_server->error()));
    bench.open(noon + 2h);
    bench.read(1, noon + 2h, 5);
    bench.writer->flush();
    QVERIFY(settle(bench));
    bench.close();
    const QList<Gap> expected{
        {1, noon + 1s, noon + 1h, GapReason::ProgramStopped, {}},
        {1, noon + 1h + 20s, noon + 2h, GapReason::ProgramStopped, {}}};
    QCOMPARE(ArchiveQuery(bench.config).gaps({1}, noon, noon + 2h), expected);
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 3h).size(), 23);
}

/// A power cut may bring back a spool that the server has already.
void TestArchivePostgres::writesNothingTwice()
{
    ArchiveBench bench(config());
    bench.open(noon);
    m_server->stop();
    for (int second = 1; second <= 50; ++second) {
        bench.read(1, noon + second * 1s, second);
        bench.writer->flush();
    }
    const QString copy = m_folder->filePath(QStringLiteral("copy"));
    QVERIFY(QFile::copy(spool(), copy));
    QVERIFY2(m_server->start(), qPrintable(m_server->error()));
    QVERIFY(settle(bench));
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 3h).size(), 50);
    bench.writer.reset();
    QVERIFY(QFile::remove(spool()) && QFile::copy(copy, spool()));
    bench.open(noon + 60s);
    bench.read(1, noon + 60s, 60);
    QVERIFY(settle(bench));
    bench.close();
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 3h).size(), 51);
}

/// The connection ends after the server has committed: the batch is in the spool too.
void TestArchivePostgres::remembersWhatWasNotAnswered()
{
    ArchiveBench bench(config());
    bench.open(noon);
    bench.read(1, noon + 1s, 1);
    bench.writer->flush();
    const QString schema = bench.config.site;
    const qint64 done =
        m_server->ask(QStringLiteral("SELECT value FROM %1.meta WHERE name = 'spooled'").arg(schema)).toLongLong();
    QVERIFY(done >= 1);
    // As if the next one were there already.
    m_server->ask(QStringLiteral("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE usename = 'gorizont' "
                                 "AND datname = 'buildings' AND '%1' = '%1'")
                      .arg(schema));
    bench.read(1, noon + 2s, 2);
    bench.writer->flush();
    QVERIFY(QFileInfo(spool()).size() > 0);
    QCOMPARE(
        m_server
            ->ask(QStringLiteral("UPDATE %1.meta SET value = %2 WHERE name = 'spooled' RETURNING value")
                      .arg(schema)
                      .arg(done + 1))
            .toLongLong(),
        done + 1);
    bench.read(1, noon + 3s, 3);
    bench.writer->flush();
    QVERIFY(settle(bench));
    const Buckets all = bench.fullRate(tiltX, noon, noon + 1h);
    QCOMPARE(all.size(), 2);
    QVERIFY(all.at(1).from == noon + 3s);
    bench.close();
}

void TestArchivePostgres::explainsAWrongPassword()
{
    ArchiveConfig wrong = config();
    wrong.password = QStringLiteral("guessed");
    ArchiveBench bench(wrong);
    bench.open(noon);
    for (int second = 1; second <= 3; ++second) {
        bench.read(1, noon + second * 1s, second);
        bench.writer->flush();
    }
    const QString expected =
        QStringLiteral("The archive is not being written: 127.0.0.1:%1/buildings (%2) refuses: password "
                       "authentication failed for user \"gorizont\". Check User, PasswordFile and Database of "
                       "[Archive]. Until it is, what is measured waits in %3.")
            .arg(wrong.port)
            .arg(wrong.site, QDir::toNativeSeparators(spool()));
    QCOMPARE(bench.sentences, QStringList{expected});
    bench.close();
    ArchiveBench right(config());
    right.open(noon + 4s);
    QVERIFY(settle(right));
    QCOMPARE(right.fullRate(tiltX, noon, noon + 1h).size(), 3);
    right.close();
}

void TestArchivePostgres::asksTheServerThatIsBack()
{
    ArchiveBench bench(config());
    bench.open(noon);
    bench.read(1, noon + 1s, 1);
    bench.close();
    ArchiveQuery query(bench.config);
    const SeriesQuery question{{tiltX}, noon, noon + 1h, 0};
    QCOMPARE(query.series(question).value(0).buckets.size(), 1);
    m_server->stop();
    QCOMPARE(query.series(question).value(0).buckets.size(), 0);
    QVERIFY2(m_server->start(), qPrintable(m_server->error()));
    QCOMPARE(query.series(question).value(0).buckets.size(), 1);
}

/// What does not fit waits in the memory, as for a full disk; one sentence says so.
void TestArchivePostgres::boundsTheSpool()
{
    ArchiveConfig small = config();
    small.mostSpoolBytes = 2000;
    ArchiveBench bench(small);
    bench.open(noon);
    m_server->stop();
    for (int second = 1; second <= 100; ++second) {
        bench.read(1, noon + second * 1s, second);
        bench.writer->flush();
        QVERIFY(QFileInfo(spool()).size() <= 2000);
    }
    QCOMPARE(bench.sentences.filter(QStringLiteral("is full")).size(), 1);
    QVERIFY2(m_server->start(), qPrintable(m_server->error()));
    QVERIFY(settle(bench));
    bench.close();
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 1h).size(), 100);
}

QTEST_GUILESS_MAIN(TestArchivePostgres)

#include "tst_archivepostgres.moc"
