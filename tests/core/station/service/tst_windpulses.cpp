#include "core/station/sources/pulsesource.h"
#include "core/station/sources/windpulses.h"

#include <QTest>

#include <cmath>
#include <condition_variable>

using namespace gorizont::station;
using namespace std::chrono_literals;

namespace {

using Time = WindPulses::Time;

/// Both series at \a period, the main one \a delay behind, from \a begin to \a end.
void feed(WindPulses &pulses, Time begin, Time end, Time period, Time delay)
{
    for (Time at = begin; at <= end; at += period) {
        pulses.addReference(at);
        pulses.addMain(at + delay);
    }
}

/// A port whose circuits the test moves.
class FakePort : public ModemPort
{
public:
    struct Script
    {
        std::mutex mutex;
        std::condition_variable changed;
        std::deque<ModemLines> lines;
        bool isGone = false;
        bool isInterrupted = false;

        void push(const ModemLines &next)
        {
            const std::lock_guard lock(mutex);
            lines.push_back(next);
            changed.notify_all();
        }
        void vanish()
        {
            const std::lock_guard lock(mutex);
            isGone = true;
            changed.notify_all();
        }
    };

    explicit FakePort(std::shared_ptr<Script> script)
        : m_script(std::move(script))
    {
    }
    QString name() const override { return QStringLiteral("fake"); }
    QString open() override { return {}; }
    void close() override {}
    std::optional<ModemLines> waitForChange() override
    {
        std::unique_lock lock(m_script->mutex);
        m_script->changed.wait(lock, [this] {
            return !m_script->lines.empty() || m_script->isGone || m_script->isInterrupted;
        });
        if (m_script->lines.empty()) {
            return std::nullopt;
        }
        const ModemLines next = m_script->lines.front();
        m_script->lines.pop_front();
        return next;
    }
    void interrupt(std::thread &) override
    {
        const std::lock_guard lock(m_script->mutex);
        m_script->isInterrupted = true;
        m_script->changed.notify_all();
    }

private:
    std::shared_ptr<Script> m_script;
};

} // namespace

class TestWindPulses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsFrequencyAndPhase_data();
    void countsFrequencyAndPhase();
    void turnsThroughNorth();
    void dropsShortPulses();
    void isCalmWithoutPulses();
    void keepsStepsOfTheMultiplier();
    void forgetsACalmBefore();
    void countsAPort();
    void saysThatAPortIsGone();
    void refusesAPortWithoutCircuits();
};

void TestWindPulses::countsFrequencyAndPhase_data()
{
    QTest::addColumn<int>("periodUs");
    QTest::addColumn<int>("delayUs");
    QTest::addColumn<double>("frequency");
    QTest::addColumn<double>("phase");
    QTest::newRow("100 Hz, a quarter behind") << 10'000 << 2500 << 100.0 << 90.0;
    QTest::newRow("50 Hz, together") << 20'000 << 0 << 50.0 << 0.0;
    QTest::newRow("8 Hz, three quarters") << 125'000 << 93'750 << 8.0 << 270.0;
    QTest::newRow("2 Hz, a half") << 500'000 << 250'000 << 2.0 << 180.0;
}

void TestWindPulses::countsFrequencyAndPhase()
{
    QFETCH(int, periodUs);
    QFETCH(int, delayUs);
    WindPulses pulses({0us, 1s, 1000});
    feed(pulses, 10s, 12s, Time(periodUs), Time(delayUs));
    const WindRaw raw = pulses.measure(12s);
    QVERIFY(raw.frequency && raw.phase);
    QTEST(*raw.frequency, "frequency");
    QTEST(*raw.phase, "phase");
}

/// Phases of 350° and 10° are 0° together, not 180°.
void TestWindPulses::turnsThroughNorth()
{
    WindPulses pulses({0us, 1s, 100});
    bool isEarly = false;
    for (Time at = 0s; at <= 2s; at += 36ms) {
        pulses.addReference(at);
        pulses.addMain(at + (isEarly ? 35ms : 1ms));
        isEarly = !isEarly;
    }
    const double phase = pulses.measure(2s).phase.value_or(180);
    QVERIFY2(phase < 1 || phase > 359, QByteArray::number(phase));
}

void TestWindPulses::dropsShortPulses()
{
    WindPulses filtered({500us, 1s, 100});
    WindPulses open({0us, 1s, 100});
    for (WindPulses *pulses : {&filtered, &open}) {
        for (Time at = 0s; at <= 2s; at += 10ms) {
            pulses->addReference(at);
            pulses->addReference(at + 200us); // a contact that bounces
        }
    }
    QCOMPARE(filtered.measure(2s).frequency, std::optional(100.0));
    QVERIFY(*open.measure(2s).frequency > 150);
}

void TestWindPulses::isCalmWithoutPulses()
{
    WindPulses pulses({0us, 1s, 100});
    QCOMPARE(pulses.measure(5s), (WindRaw{0.0, std::nullopt}));
    feed(pulses, 5s, 6s, 10ms, 1ms);
    QVERIFY(pulses.measure(6s).phase);
    QCOMPARE(pulses.measure(9s), (WindRaw{0.0, std::nullopt}));
}

void TestWindPulses::keepsStepsOfTheMultiplier()
{
    for (const auto &[multiplier, expected] : {std::pair{1, 33.0}, std::pair{10, 33.3}, std::pair{1000, 33.333}}) {
        WindPulses pulses({0us, 1s, multiplier});
        feed(pulses, 0s, 2s, 30ms, 0us); // 33.333… Hz
        QCOMPARE(*pulses.measure(2s).frequency, expected);
    }
}

/// The first pulse after an hour without wind is not the end of a period of an hour.
void TestWindPulses::forgetsACalmBefore()
{
    WindPulses pulses({0us, 1s, 100});
    pulses.addReference(0s);
    for (Time at = 3600s; at <= 3601s; at += 100ms) {
        pulses.addReference(at);
    }
    QCOMPARE(*pulses.measure(3601s).frequency, 10.0);
}

void TestWindPulses::countsAPort()
{
    auto script = std::make_shared<FakePort::Script>();
    PulseSource source(std::make_unique<FakePort>(script), {0us, 5s, 100}, 2);
    QCOMPARE(source.open(), QString());
    for (int i = 0; i < 11; ++i) {
        script->push({true, false});
        QTest::qSleep(5);
        script->push({true, true});
        QTest::qSleep(5);
        script->push({false, false});
        QTest::qSleep(10);
    }
    RawSample sample;
    QCOMPARE(source.measure({}, sample), QString());
    QVERIFY(!sample.winds[0].frequency);
    // 20 ms or more between two pulses, whatever the computer does meanwhile; but the first may be heard late.
    QVERIFY2(
        *sample.winds[2].frequency > 1 && *sample.winds[2].frequency < 100,
        QByteArray::number(*sample.winds[2].frequency));
    QVERIFY(sample.winds[2].phase);
}

void TestWindPulses::saysThatAPortIsGone()
{
    auto script = std::make_shared<FakePort::Script>();
    PulseSource source(std::make_unique<FakePort>(script), {}, 0);
    QCOMPARE(source.open(), QString());
    RawSample sample;
    QCOMPARE(source.measure({}, sample), QString());
    script->vanish();
    QTRY_VERIFY(!source.measure({}, sample).isEmpty());
}

void TestWindPulses::refusesAPortWithoutCircuits()
{
    PulseSource missing(makeModemPort(QStringLiteral("/dev/there-is-no-such-port")), {}, 0);
    QVERIFY(!missing.open().isEmpty());
    PulseSource file(makeModemPort(QStringLiteral("/dev/null")), {}, 0);
    QVERIFY(!file.open().isEmpty());
}

QTEST_GUILESS_MAIN(TestWindPulses)

#include "tst_windpulses.moc"
