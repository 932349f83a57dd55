#include "tests/core/archive/archivesite.h"

#include <QElapsedTimer>
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
            ArchiveDatabase database(config, ArchiveDatabase::Access::Salvage);
            m_isHeld = database.open() && database.execute(QStringLiteral("PRAGMA locking_mode=EXCLUSIVE"))
                && database.single(QStringLiteral("SELECT count(*) FROM meta")).isValid();
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

private:
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite")); }
    bool execute(const ArchiveConfig &config, const QString &sql) const
    {
        ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
        return database.open() && database.execute(sql);
    }

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
    QVERIFY(execute(config, QStringLiteral("ALTER TABLE event RENAME TO elsewhere")));
    writer.appendJournal({JournalKind::Info, start, QStringLiteral("x"), 0, 0});
    read(); // fails and closes the store
    QVERIFY(execute(config, QStringLiteral("ALTER TABLE elsewhere RENAME TO event")));
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
    QCOMPARE(query.series({{tiltX}, start, end, 0}).value(0).buckets.size(), 5);
    for (const Gap &gap : query.gaps({1}, start, end)) {
        QVERIFY(gap.reason != GapReason::Clock);
    }
}

QTEST_GUILESS_MAIN(TestArchiveRecovery)

#include "tst_archiverecovery.moc"
