#include "core/archive/retention.h"
#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What it costs to remove what is too old, and what it brings.
class TestRetentionRoom : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void theFileBecomesSmaller();
    void theRoomIsKept();
    void findsWhatIsExpiredByAnIndex_data();
    void findsWhatIsExpiredByAnIndex();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("a.sqlite")); }
    void fill(int chunks);
    void sweepAll(Retention::Room room);
    qint64 settledSize();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ArchiveStore> m_store;
};

void TestRetentionRoom::init()
{
    m_store.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_store = std::make_unique<ArchiveStore>(archiveConfig(file()));
    QVERIFY(m_store->database().open());
}

/// A chunk of 4 kB an hour.
void TestRetentionRoom::fill(int chunks)
{
    QVERIFY(m_store->database().begin());
    QVERIFY(m_store->putSensor(1, {noon, noon + chunks * 1h, 0, 0}));
    for (int i = 0; i < chunks; ++i) {
        QVERIFY(
            m_store->appendChunk(ChunkKind::FullRate, 1, {noon + i * 1h, noon + (i + 1) * 1h}, QByteArray(4000, 'x')));
    }
    QVERIFY(m_store->database().commit());
}

/// The last tenth of 3000 chunks stays.
void TestRetentionRoom::sweepAll(Retention::Room room)
{
    ArchiveRetention retention;
    retention.readings = 300h;
    Retention sweeper(retention);
    auto outcome = Retention::Outcome::MoreToDo;
    for (int sweeps = 0; sweeps < 100 && outcome == Retention::Outcome::MoreToDo; ++sweeps) {
        outcome = sweeper.sweep(*m_store, noon + 3000h, room);
    }
    QCOMPARE(outcome, Retention::Outcome::Done);
    QCOMPARE(m_store->database().single(QStringLiteral("SELECT count(*) FROM chunk")).toInt(), 301);
}

/// Once what is in the log is in the file.
qint64 TestRetentionRoom::settledSize()
{
    m_store->database().close();
    return QFileInfo(file()).size();
}

void TestRetentionRoom::theFileBecomesSmaller()
{
    fill(3000);
    QVERIFY(settledSize() > 12'000'000);
    QVERIFY(m_store->database().open());
    sweepAll(Retention::Room::GivenBack);
    QCOMPARE(m_store->database().single(QStringLiteral("PRAGMA freelist_count")).toInt(), 0);
    const qint64 size = settledSize();
    QVERIFY2(size < 2'000'000, qPrintable(QString::number(size)));
    QVERIFY(m_store->database().open());
    QCOMPARE(m_store->database().single(QStringLiteral("PRAGMA integrity_check")).toString(), QStringLiteral("ok"));
}

void TestRetentionRoom::theRoomIsKept()
{
    fill(3000);
    sweepAll(Retention::Room::Kept);
    QVERIFY(m_store->database().single(QStringLiteral("PRAGMA freelist_count")).toInt() > 500);
}

void TestRetentionRoom::findsWhatIsExpiredByAnIndex_data()
{
    QTest::addColumn<ChunkKind>("kind");
    QTest::addColumn<QString>("search");
    const QString chunk = QStringLiteral("SEARCH chunk USING INDEX chunk_by_time (kind=? AND number=? AND start<?)");
    const QString rollup =
        QStringLiteral("SEARCH rollup USING %1INDEX rollup_by_time (kind=? AND number=? AND quantity=? AND start<?)");
    QTest::newRow("readings") << ChunkKind::FullRate << chunk;
    QTest::newRow("samples") << ChunkKind::Samples << chunk;
    QTest::newRow("minutes") << ChunkKind::Minutes << rollup.arg(QStringLiteral("COVERING "));
    QTest::newRow("days") << ChunkKind::Days << rollup.arg(QStringLiteral("COVERING "));
}

void TestRetentionRoom::findsWhatIsExpiredByAnIndex()
{
    QFETCH(ChunkKind, kind);
    QFETCH(QString, search);
    QSqlQuery *rows = m_store->database().run(
        QStringLiteral("EXPLAIN QUERY PLAN SELECT id FROM %1 LIMIT 300").arg(expiredRows(kind)),
        kind == ChunkKind::FullRate || kind == ChunkKind::Samples ? QVariantList{1, 1} : QVariantList{1});
    QVERIFY2(rows, qPrintable(m_store->database().error()));
    QStringList plan;
    while (rows->next()) {
        plan.append(rows->value(3).toString());
    }
    QVERIFY2(plan.contains(search), qPrintable(plan.join(u'\n')));
}

QTEST_GUILESS_MAIN(TestRetentionRoom)

#include "tst_retentionroom.moc"
