#include "core/engine/lineworker.h"
#include "core/simulation/simulatedline.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

using namespace gorizont;
using namespace std::chrono_literals;
using std::chrono::milliseconds;

namespace {

/// What the line of a test was put through; other threads look at it.
struct Diary
{
    QMutex mutex;
    QList<SteadyTime> attempts; ///< to open
    std::optional<SteadyTime> lostAt;

    QList<milliseconds> gaps()
    {
        const QMutexLocker lock(&mutex);
        QList<milliseconds> gaps;
        for (qsizetype i = 1; i < attempts.size(); ++i) {
            gaps.append(std::chrono::duration_cast<milliseconds>(attempts.at(i) - attempts.at(i - 1)));
        }
        return gaps;
    }
};

/// Cannot be opened, or vanishes with its first request.
class BrokenLine : public SimulatedLine
{
public:
    enum class Fate : quint8 { NeverOpens, VanishesOnce };

    BrokenLine(const LineConfig &config, Fate fate, Diary &diary)
        : SimulatedLine(config, {}, std::chrono::steady_clock::now(), 100ms)
        , m_fate(fate)
        , m_diary(diary)
    {
    }

    Result<void> open() override
    {
        const QMutexLocker lock(&m_diary.mutex);
        m_diary.attempts.append(std::chrono::steady_clock::now());
        return m_fate == Fate::NeverOpens ? Result<void>(Fault::Closed) : SimulatedLine::open();
    }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override
    {
        const QMutexLocker lock(&m_diary.mutex);
        if (!m_diary.lostAt) {
            m_diary.lostAt = std::chrono::steady_clock::now();
            close();
        }
        return SimulatedLine::writeAll(bytes, timeout);
    }

private:
    Fate m_fate;
    Diary &m_diary;
};

PollingSettings settings(const Timing &timing)
{
    PollingSettings settings;
    settings.line.index = 1;
    settings.line.isOn = true;
    SensorConfig sensor;
    sensor.number = 1;
    sensor.isOn = true;
    sensor.type = SensorType::InD;
    sensor.measuresTilt = true;
    settings.line.sensors = {sensor};
    settings.timing = timing;
    return settings;
}

/// A worker in a thread of its own.
class Bench
{
public:
    Bench(const Timing &timing, BrokenLine::Fate fate)
        : worker(settings(timing), [this, fate, line = settings(timing).line] {
            return std::make_unique<BrokenLine>(line, fate, diary);
        })
    {
        worker.moveToThread(&thread);
        QObject::connect(&thread, &QThread::started, &worker, &LineWorker::start);
        QObject::connect(&thread, &QThread::finished, &worker, &LineWorker::stop, Qt::DirectConnection);
        thread.start();
    }

    ~Bench()
    {
        worker.interrupt();
        thread.quit();
        thread.wait();
    }

    qsizetype attempts()
    {
        const QMutexLocker lock(&diary.mutex);
        return diary.attempts.size();
    }

    Diary diary;
    QThread thread;
    LineWorker worker;
};

constexpr milliseconds rounding{2}; // a timer counts whole milliseconds

} // namespace

/// PReOpen, PClose and TmUpdateInt of the ini on a port that breaks. A machine may be late with everything, so the pauses
/// are looked at from below, and from above only against the pause that must not have been taken.
class TestPortPauses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pReOpenComesAfterAFailedAttempt_data();
    void pReOpenComesAfterAFailedAttempt();
    void pCloseComesAfterALoss_data();
    void pCloseComesAfterALoss();
    void tmUpdateIntIsThePeriodOfTheLinesState();
};

void TestPortPauses::pReOpenComesAfterAFailedAttempt_data()
{
    QTest::addColumn<int>("pause");
    QTest::newRow("short") << 60;
    QTest::newRow("longer") << 400;
}

void TestPortPauses::pReOpenComesAfterAFailedAttempt()
{
    QFETCH(int, pause);
    Timing timing;
    timing.reopenPause = milliseconds(pause);
    timing.closePause = 60s;
    Bench bench(timing, BrokenLine::Fate::NeverOpens);
    QTRY_VERIFY_WITH_TIMEOUT(bench.attempts() >= 4, 30000);
    for (const milliseconds gap : bench.diary.gaps()) {
        QVERIFY2(gap + rounding >= milliseconds(pause), qPrintable(QString::number(gap.count())));
    }
}

void TestPortPauses::pCloseComesAfterALoss_data()
{
    QTest::addColumn<int>("pause");
    QTest::newRow("none") << 0;
    QTest::newRow("some") << 700;
}

void TestPortPauses::pCloseComesAfterALoss()
{
    QFETCH(int, pause);
    Timing timing;
    timing.closePause = milliseconds(pause);
    timing.reopenPause = 60s;
    Bench bench(timing, BrokenLine::Fate::VanishesOnce);
    QTRY_VERIFY_WITH_TIMEOUT(bench.attempts() >= 2, 30000);
    const QMutexLocker lock(&bench.diary.mutex);
    const auto gap = bench.diary.attempts.at(1) - *bench.diary.lostAt;
    QVERIFY(gap + rounding >= milliseconds(pause));
    QVERIFY(gap < 30s); // it was not PReOpen
}

/// The counters of a port are told once in TmUpdateInt, not with every cycle.
void TestPortPauses::tmUpdateIntIsThePeriodOfTheLinesState()
{
    for (const milliseconds interval : {1ms, 60000ms}) {
        Timing timing;
        timing.run = 5ms;
        timing.closePause = 0ms;
        timing.updateInterval = interval;
        Bench bench(timing, BrokenLine::Fate::VanishesOnce);
        QSignalSpy cycles(&bench.worker, &LineWorker::readingsReady);
        QSignalSpy states(&bench.worker, &LineWorker::lineChanged);
        QTRY_VERIFY(cycles.size() > 60);
        // Open, lost, open again: a change is told at once.
        QVERIFY2((states.size() <= 3) == (interval > 1s), qPrintable(QString::number(states.size())));
    }
}

QTEST_GUILESS_MAIN(TestPortPauses)
#include "tst_portpauses.moc"
