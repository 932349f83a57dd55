#include "core/station/sources/sourcerunner.h"

#include <QStringList>
#include <QTest>

#include <atomic>
#include <condition_variable>
#include <mutex>

using namespace gorizont;
using namespace gorizont::station;
using namespace std::chrono_literals;

namespace {

/// What a test does to a source from outside; outlives it.
struct Fate
{
    std::mutex mutex;
    std::condition_variable changed;
    bool isHanging = false;
    QString death; ///< why it dies at the next measurement
    std::atomic_int made{0};
    std::atomic_int measured{0};
    std::atomic<quint32> outputs{0};
};

class FatedSource : public Source
{
public:
    explicit FatedSource(std::shared_ptr<Fate> fate)
        : m_fate(std::move(fate))
    {
        ++m_fate->made;
    }
    QString name() const override { return QStringLiteral("fated"); }
    double rate() const override { return 100; }
    QString open() override { return {}; }
    QString measure(const SampleMoment &moment, RawSample &sample) override
    {
        std::unique_lock lock(m_fate->mutex);
        m_fate->changed.wait(lock, [this] { return !m_fate->isHanging; });
        sample.analogue[0] = 1.5;
        m_fate->outputs = moment.outputs;
        ++m_fate->measured;
        return m_fate->death;
    }

private:
    std::shared_ptr<Fate> m_fate;
};

class Watching
{
public:
    explicit Watching(std::chrono::seconds watchdog)
        : m_watch(
            {[this] { return std::make_unique<FatedSource>(fate); }}, watchdog,
            [this](bool isGood, const QString &text) { told += QString(isGood ? u'+' : u'-') + text; }, m_now)
    {
    }

    /// A second passes.
    RawSample step(std::chrono::milliseconds passed = 1s) { return m_watch.take(m_now += passed); }
    /// Whether a value comes within a few seconds, while the clock of the station stands.
    bool hasValue()
    {
        return QTest::qWaitFor([this] { return step(0ms).analogue[0] == std::optional(1.5); }, 5000);
    }
    void setOutputs(quint32 word) { m_watch.setOutputs(word); }

    std::shared_ptr<Fate> fate = std::make_shared<Fate>();
    QStringList told;

private:
    SteadyTime m_now{1h};
    SourceWatch m_watch;
};

} // namespace

class TestSourceWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresAtItsRate();
    void restartsWhatDies();
    void restartsWhatHangs();
    void waitsForEverWithoutAWatchdog();
    void tellsTheOutputs();
};

void TestSourceWatch::measuresAtItsRate()
{
    Watching watching(30s);
    const auto start = std::chrono::steady_clock::now();
    QTRY_VERIFY(watching.fate->measured >= 50);
    const auto passed = std::chrono::steady_clock::now() - start;
    QVERIFY2(passed > 450ms, "faster than its rate");
    QCOMPARE(watching.step().analogue[0], std::optional(1.5));
    QCOMPARE(watching.told, QStringList());
}

void TestSourceWatch::restartsWhatDies()
{
    Watching watching(30s);
    QVERIFY(watching.hasValue());
    {
        const std::lock_guard lock(watching.fate->mutex);
        watching.fate->death = QStringLiteral("the cable is cut");
    }
    QTRY_COMPARE((watching.step(0ms), watching.told.size()), 1);
    QVERIFY(watching.told.constFirst().startsWith(u'-'));
    QVERIFY(watching.told.constFirst().contains(QStringLiteral("the cable is cut")));
    QCOMPARE(watching.step(9s), RawSample()); // no value, and no new start yet
    QCOMPARE(watching.fate->made.load(), 1);
    watching.step(1s);
    QCOMPARE(watching.fate->made.load(), 2);
    // It dies again: that is not said again.
    QTest::qSleep(100);
    watching.step(0ms);
    QCOMPARE(watching.told.size(), 1);
    {
        const std::lock_guard lock(watching.fate->mutex);
        watching.fate->death.clear();
    }
    watching.step(10s);
    QCOMPARE(watching.fate->made.load(), 3);
    QVERIFY(watching.hasValue());
    QCOMPARE(watching.told.size(), 2);
    QVERIFY(watching.told.constLast().startsWith(u'+'));
}

/// A source that hangs in the system cannot be ended; it is left alone, and another one takes its place.
void TestSourceWatch::restartsWhatHangs()
{
    Watching watching(5s);
    QVERIFY(watching.hasValue());
    {
        const std::lock_guard lock(watching.fate->mutex);
        watching.fate->isHanging = true;
    }
    QTest::qSleep(50);
    watching.step(0ms);
    const auto start = std::chrono::steady_clock::now();
    for (int second = 0; second < 5; ++second) {
        QCOMPARE(watching.step(), RawSample());
        QCOMPARE(watching.told.size(), 0);
    }
    watching.step();
    QCOMPARE(watching.told.size(), 1);
    QVERIFY2(std::chrono::steady_clock::now() - start < 400ms, "the station waited for it");
    {
        const std::lock_guard lock(watching.fate->mutex);
        watching.fate->isHanging = false;
        watching.fate->changed.notify_all();
    }
    watching.step(10s);
    QCOMPARE(watching.fate->made.load(), 2);
    QVERIFY(watching.hasValue());
    QCOMPARE(watching.told.size(), 2);
}

void TestSourceWatch::waitsForEverWithoutAWatchdog()
{
    Watching watching(0s);
    {
        const std::lock_guard lock(watching.fate->mutex);
        watching.fate->isHanging = true;
    }
    QTest::qSleep(50);
    watching.step(0ms);
    QCOMPARE(watching.step(24h), RawSample());
    QCOMPARE(watching.told.size(), 0);
    const std::lock_guard lock(watching.fate->mutex);
    watching.fate->isHanging = false;
    watching.fate->changed.notify_all();
}

void TestSourceWatch::tellsTheOutputs()
{
    Watching watching(30s);
    watching.setOutputs(0x80000001);
    QTRY_COMPARE(watching.fate->outputs.load(), 0x80000001U);
}

QTEST_GUILESS_MAIN(TestSourceWatch)

#include "tst_sourcewatch.moc"
