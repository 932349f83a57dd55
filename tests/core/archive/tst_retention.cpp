#include "core/archive/retention.h"
#include "tests/core/archive/archivesite.h"

#include <QFileInfo>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

class TestRetention : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void rollupsOutliveReadings();
    void removesEventsAndGaps();
    void removesTheOldestOfWhatIsTooLarge();
    void removesNothingUnasked();

private:
    int count(ArchiveStore &store, const QString &rows)
    {
        return store.database().single(QStringLiteral("SELECT count(*) FROM ") + rows).toInt();
    }
    void fill(int chunks, qsizetype bytes);
    int sweepAll(const ArchiveRetention &retention, UtcTime now);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ArchiveStore> m_store;
};

void TestRetention::init()
{
    m_store.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_store = std::make_unique<ArchiveStore>(archiveConfig(m_folder->filePath(QStringLiteral("a.sqlite"))));
    QVERIFY(m_store->database().open());
}

/// One of each an hour: \a chunks readings, samples, rollups of minutes, events and gaps.
void TestRetention::fill(int chunks, qsizetype bytes)
{
    QVERIFY(m_store->database().begin());
    QVERIFY(m_store->putSensor(1, {noon, noon + chunks * 1h, 0, 0}));
    for (int i = 0; i < chunks; ++i) {
        const TimeSpan span{noon + i * 1h, noon + (i + 1) * 1h};
        const QByteArray data(bytes, 'x');
        QVERIFY(m_store->appendChunk(ChunkKind::FullRate, 1, span, data));
        QVERIFY(m_store->appendChunk(ChunkKind::Samples, 1, span, data));
        QVERIFY(m_store->putRollup(ChunkKind::Minutes, {1, Quantity::TiltX}, noon + i * 6h, data));
        QVERIFY(m_store->appendEvent({JournalKind::Info, span.from, QStringLiteral("x"), 0, 0}));
        QVERIFY(m_store->putGap({1, span.from, span.to, GapReason::Crc, {}}));
    }
    QVERIFY(m_store->database().commit());
}

/// How many sweeps it took; −1: one failed.
int TestRetention::sweepAll(const ArchiveRetention &retention, UtcTime now)
{
    Retention sweeper(retention);
    for (int sweeps = 1; sweeps < 1000; ++sweeps) {
        const auto outcome = sweeper.sweep(*m_store, now);
        if (outcome != Retention::Outcome::MoreToDo) {
            return outcome == Retention::Outcome::Done ? sweeps : -1;
        }
    }
    return -1;
}

void TestRetention::rollupsOutliveReadings()
{
    fill(1000, 10);
    ArchiveRetention retention;
    retention.readings = 24h;
    retention.samples = 48h;
    QVERIFY(sweepAll(retention, noon + 1000h) > 1);
    QCOMPARE(count(*m_store, QStringLiteral("chunk WHERE kind = 1")), 25);
    QCOMPARE(count(*m_store, QStringLiteral("chunk WHERE kind = 2")), 49);
    QCOMPARE(count(*m_store, QStringLiteral("rollup")), 1000);
    QCOMPARE(count(*m_store, QStringLiteral("event")), 1000);
    retention.rollups = 60h;
    QVERIFY(sweepAll(retention, noon + 6000h) > 0);
    QCOMPARE(count(*m_store, QStringLiteral("rollup")), 11);
    QCOMPARE(count(*m_store, QStringLiteral("chunk")), 0);
}

void TestRetention::removesEventsAndGaps()
{
    fill(100, 10);
    QVERIFY(m_store->putGap({2, noon, {}, GapReason::Crc, {}}));
    ArchiveRetention retention;
    retention.events = 24h;
    QVERIFY(sweepAll(retention, noon + 100h) > 0);
    QCOMPARE(count(*m_store, QStringLiteral("event")), 24);
    QCOMPARE(count(*m_store, QStringLiteral("gap WHERE number = 1")), 25);
    QCOMPARE(count(*m_store, QStringLiteral("gap WHERE number = 2")), 1);
    QCOMPARE(count(*m_store, QStringLiteral("chunk")), 200);
}

void TestRetention::removesTheOldestOfWhatIsTooLarge()
{
    fill(2000, 4000);
    ArchiveRetention retention;
    retention.mostBytes = 14'000'000;
    QVERIFY(usedBytes(m_store->database()) > 20'000'000);
    QVERIFY(sweepAll(retention, noon) > 1);
    QVERIFY(usedBytes(m_store->database()) <= 14'000'000);
    QVERIFY(count(*m_store, QStringLiteral("chunk")) > 0);
    QCOMPARE(count(*m_store, QStringLiteral("chunk WHERE start < %1").arg(storedTime(noon + 100h))), 0);
    QCOMPARE(count(*m_store, QStringLiteral("rollup")), 2000);
    QCOMPARE(count(*m_store, QStringLiteral("event")), 2000);
    retention.mostBytes = 1'000'000;
    QVERIFY(sweepAll(retention, noon) > 1);
    QCOMPARE(count(*m_store, QStringLiteral("chunk")), 0);
    QVERIFY(usedBytes(m_store->database()) <= 1'000'000);
    QCOMPARE(m_store->database().single(QStringLiteral("PRAGMA freelist_count")).toInt(), 0);
    m_store->database().close();
    QVERIFY(QFileInfo(m_folder->filePath(QStringLiteral("a.sqlite"))).size() <= 1'100'000);
}

void TestRetention::removesNothingUnasked()
{
    fill(50, 10);
    QCOMPARE(sweepAll({}, noon + 100'000h), 1);
    QCOMPARE(count(*m_store, QStringLiteral("chunk")), 100);
    QCOMPARE(count(*m_store, QStringLiteral("event")), 50);
}

QTEST_GUILESS_MAIN(TestRetention)

#include "tst_retention.moc"
