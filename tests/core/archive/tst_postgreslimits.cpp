#include "core/archive/retention.h"
#include "tests/core/archive/archivesite.h"
#include "tests/core/archive/postgresserver.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What bounds the archive on a server, and what does not.
class TestPostgresLimits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanupTestCase();
    void theSizeRemovesNothing();
    void theAgeRemoves();
    void onlyReadersHaveATimeout();
    void aQuestionThatFailsIsTold();

private:
    ArchiveConfig config() const
    {
        return m_server->config(
            QStringLiteral("site_%1").arg(m_count), m_folder->filePath(QStringLiteral("archive.sqlite")));
    }
    void fill(ArchiveStore &store) const;

    std::unique_ptr<PostgresServer> m_server;
    std::unique_ptr<QTemporaryDir> m_folder;
    int m_count = 0;
};

void TestPostgresLimits::initTestCase()
{
    if (const QString reason = PostgresServer::whyNot(); !reason.isEmpty()) {
        QVERIFY2(!qEnvironmentVariableIsSet("GORIZONT_REQUIRE_POSTGRESQL"), qPrintable(reason));
        QSKIP(qPrintable(reason));
    }
    m_server = std::make_unique<PostgresServer>();
    QVERIFY2(m_server->create(), qPrintable(m_server->error()));
}

void TestPostgresLimits::cleanupTestCase()
{
    m_server.reset();
}

void TestPostgresLimits::init()
{
    ++m_count;
    m_folder = std::make_unique<QTemporaryDir>();
}

/// A chunk and a rollup an hour, 500 of each.
void TestPostgresLimits::fill(ArchiveStore &store) const
{
    QVERIFY(store.database().begin());
    QVERIFY(store.putSensor(1, {noon, noon + 500h, 0, 0}));
    for (int i = 0; i < 500; ++i) {
        QVERIFY(store.appendChunk(ChunkKind::FullRate, 1, {noon + i * 1h, noon + (i + 1) * 1h}, QByteArray(500, 'x')));
        QVERIFY(store.putRollup(ChunkKind::Minutes, {1, Quantity::TiltX}, noon + i * 6h, QByteArray(500, 'x')));
    }
    QVERIFY(store.database().commit());
}

void TestPostgresLimits::theSizeRemovesNothing()
{
    ArchiveStore store(config());
    QVERIFY(store.database().open());
    fill(store);
    ArchiveRetention retention;
    retention.mostBytes = 10'000;
    QVERIFY(usedBytes(store.database()) > 100'000);
    Retention sweeper(retention);
    for (int i = 0; i < 5; ++i) {
        QCOMPARE(sweeper.sweep(store, noon + 1000h), Retention::Outcome::Done);
    }
    QCOMPARE(store.database().single(QStringLiteral("SELECT count(*) FROM chunk")).toInt(), 500);
}

void TestPostgresLimits::theAgeRemoves()
{
    ArchiveStore store(config());
    QVERIFY(store.database().open());
    fill(store);
    ArchiveRetention retention;
    retention.readings = 100h;
    retention.rollups = 600h;
    Retention sweeper(retention);
    auto outcome = Retention::Outcome::MoreToDo;
    for (int i = 0; i < 10 && outcome == Retention::Outcome::MoreToDo; ++i) {
        outcome = sweeper.sweep(store, noon + 1000h);
    }
    QCOMPARE(outcome, Retention::Outcome::Done);
    QCOMPARE(store.database().single(QStringLiteral("SELECT count(*) FROM chunk")).toInt(), 0);
    QCOMPARE(store.database().single(QStringLiteral("SELECT count(*) FROM rollup")).toInt(), 434); // from 396 h on
}

void TestPostgresLimits::onlyReadersHaveATimeout()
{
    const auto timeout = [this](ArchiveDatabase::Access access) {
        ArchiveDatabase database(config(), access);
        return database.open()
            ? database.single(QStringLiteral("SELECT current_setting('statement_timeout')")).toString()
            : QString();
    };
    QCOMPARE(timeout(ArchiveDatabase::Access::Write), QStringLiteral("0"));
    QCOMPARE(timeout(ArchiveDatabase::Access::Read), QStringLiteral("1min"));
}

void TestPostgresLimits::aQuestionThatFailsIsTold()
{
    ArchiveQuery query(config());
    QCOMPARE(query.events(noon, noon + 1h, 5).size(), 0);
    QVERIFY(!query.takeFailure()); // there is no archive yet
    ArchiveBench bench(config());
    bench.open(noon);
    bench.read(1, noon + 1s, 1);
    bench.close();
    const SeriesQuery question{{{1, Quantity::TiltX}}, noon, noon + 1h, 0};
    QCOMPARE(query.series(question).value(0).buckets.size(), 1);
    QVERIFY(!query.takeFailure());
    m_server->stop();
    QCOMPARE(query.series(question).value(0).buckets.size(), 0);
    QVERIFY(query.takeFailure());
    QVERIFY2(m_server->start(), qPrintable(m_server->error()));
    QCOMPARE(query.series(question).value(0).buckets.size(), 1);
    QVERIFY(!query.takeFailure());
}

QTEST_GUILESS_MAIN(TestPostgresLimits)

#include "tst_postgreslimits.moc"
