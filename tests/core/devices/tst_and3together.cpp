#include "core/devices/and3/and3driver.h"
#include "core/devices/and3/and3simulator.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace std::chrono_literals;

namespace {

constexpr UtcTime noon{std::chrono::seconds(1'700'000'000)};
constexpr double scale = -0.00594713; // mm/s²

/// A line with one simulated sensor at its other end, on a clock of its own. Bytes take the time they take at 115200.
class SimulatorLine : public Line
{
public:
    explicit SimulatorLine(SimulatedDevice &device)
        : Line(100ms)
        , m_device(device)
    {
    }

    SimulatedDevice::Time time() const { return m_time; }
    void wait(SimulatedDevice::Time time) { m_time += time; }
    void setBroken(bool isBroken) { m_isBroken = isBroken; }

    Result<void> open() override { return {}; }
    void close() override {}
    bool isOpen() const override { return true; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds) override
    {
        m_time += std::chrono::microseconds(87 * bytes.size());
        m_answer = m_isBroken ? QByteArray() : m_device.receive(bytes, m_time);
        return {};
    }

    Result<QByteArray> readSome(std::chrono::microseconds timeout) override
    {
        m_time += m_answer.isEmpty() ? timeout : std::chrono::microseconds(87 * m_answer.size());
        return std::exchange(m_answer, {});
    }

    SteadyTime now() const override { return SteadyTime(1h) + m_time; }
    void sleepUntil(SteadyTime time) override
    {
        m_time = std::max(m_time, std::chrono::ceil<SimulatedDevice::Time>(time - SteadyTime(1h)));
    }

private:
    SimulatedDevice &m_device;
    SimulatedDevice::Time m_time{0};
    QByteArray m_answer;
    bool m_isBroken = false;
};

SensorConfig sensorOfTest()
{
    SensorConfig sensor;
    sensor.number = 5;
    sensor.address = 17;
    sensor.measuresTilt = true;
    sensor.measuresTemperature = true;
    sensor.measuresAcceleration = true;
    return sensor;
}

/// Polls once a second and takes what there is, as an engine would.
struct Site
{
    void turn()
    {
        const auto read = driver.poll(line);
        if (!read) {
            ++failures;
        } else {
            conditions |= read->conditions;
            last = *read;
        }
        while (driver.hasBacklog()) {
            const auto fetched = driver.fetch(line);
            if (fetched) {
                blocks += *fetched;
            }
        }
    }

    void run(std::chrono::seconds duration)
    {
        const auto end = line.time() + duration;
        while (line.time() < end) {
            const auto next = line.time() + 1s;
            turn();
            line.wait(std::max(next - line.time(), SimulatedDevice::Time(0)));
        }
    }

    And3Simulator device{sensorOfTest(), 42};
    SimulatorLine line{device};
    And3Driver driver{DriverSettings{.sensor = sensorOfTest(), .timing = {}}, [this] { return noon + line.time(); }};
    QList<SampleBlock> blocks;
    Measurement last;
    Conditions conditions;
    int failures = 0;
};

/// Every sample of \a blocks is that of the building at its place after \a first (samples since the start), and each
/// block says when that was.
void compareSamples(const QList<SampleBlock> &blocks, qint64 first)
{
    const BuildingMotion motion(42, 5);
    for (qsizetype i = 0; i < blocks.size(); ++i) {
        const SampleBlock &block = blocks.at(i);
        QCOMPARE(block.x.size(), 32);
        QCOMPARE(block.y.size(), 32);
        for (int k = 0; k < 32; ++k) {
            const SimulatedDevice::Time at = (first + i * 32 + k) * SimulatedDevice::Time(100ms);
            QVERIFY(qAbs(block.x.at(k) * scale - motion.accelerationX(at)) < 0.003);
            QVERIFY(qAbs(block.y.at(k) * scale - motion.accelerationY(at)) < 0.003);
        }
        const auto error = block.start - (noon + (first + i * 32) * SimulatedDevice::Time(100ms));
        QVERIFY(std::chrono::abs(error) < 200ms);
    }
}

} // namespace

/// The driver and the simulator, each written from the description on its own.
class TstAnd3Together : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everySampleOnceAndInOrder();
    void lateStartReadsWhatIsThere();
    void shortBreakLosesNothing();
    void longBreakIsAnOverrun();
    void faultOverrun();
    void faultReboot();
    void resetByCommand();
    void pausedRecordingIsResumed();
};

void TstAnd3Together::everySampleOnceAndInOrder()
{
    Site site;
    site.run(20min);
    QCOMPARE(site.failures, 0);
    QVERIFY(site.blocks.size() >= 374 && site.blocks.size() <= 375); // 1200 s of 3.2 s
    compareSamples(site.blocks, 0);
    for (qsizetype i = 0; i < site.blocks.size(); ++i) {
        QCOMPARE(site.blocks.at(i).followsPrevious, i > 0);
    }
    for (qsizetype i = 1; i < site.blocks.size(); ++i) {
        QVERIFY(site.blocks.at(i).start - site.blocks.at(i - 1).start == 3200ms);
    }
    QVERIFY(site.conditions == (Condition::Rebooted | Condition::FanError)); // the flag of the first poll
    QVERIFY(!site.last.conditions.testFlag(Condition::Rebooted));
    QCOMPARE(site.driver.takeNotes().size(), 1);
}

void TstAnd3Together::lateStartReadsWhatIsThere()
{
    Site site;
    site.line.wait(1h); // 1125 packets
    site.run(30s);
    QVERIFY(site.blocks.size() >= 119 + 9);
    compareSamples(site.blocks, qint64(1125 - 119) * 32);
    QVERIFY(!site.conditions.testFlag(Condition::RingOverrun));
}

void TstAnd3Together::shortBreakLosesNothing()
{
    Site site;
    site.run(60s);
    site.line.setBroken(true);
    site.run(5min);
    QVERIFY(site.failures > 200);
    site.line.setBroken(false);
    site.driver.restart();
    site.run(60s);
    QVERIFY(site.blocks.size() >= 130);
    compareSamples(site.blocks, 0);
    for (qsizetype i = 1; i < site.blocks.size(); ++i) {
        QVERIFY(site.blocks.at(i).followsPrevious);
    }
}

void TstAnd3Together::longBreakIsAnOverrun()
{
    Site site;
    site.run(60s);
    const qsizetype before = site.blocks.size();
    site.line.wait(10min);
    site.run(60s);
    QVERIFY(site.conditions.testFlag(Condition::RingOverrun));
    QVERIFY(!site.last.conditions.testFlag(Condition::RingOverrun));
    QVERIFY(!site.blocks.at(before).followsPrevious);
    QVERIFY(site.blocks.at(before + 1).followsPrevious);
    compareSamples(site.blocks.mid(before), qint64(660 * 10 / 32 - 1) * 32);
}

void TstAnd3Together::faultOverrun()
{
    Site site;
    site.run(60s);
    const qsizetype before = site.blocks.size();
    site.device.overrunRing(site.line.time());
    site.turn();
    QVERIFY(site.last.conditions.testFlag(Condition::RingOverrun));
    site.run(60s);
    QVERIFY(!site.last.conditions.testFlag(Condition::RingOverrun));
    QVERIFY(!site.conditions.testFlag(Condition::SyncError));
    QVERIFY(!site.blocks.at(before).followsPrevious);
    QVERIFY(site.blocks.size() > before + 15);
}

void TstAnd3Together::faultReboot()
{
    Site site;
    site.run(60s);
    site.driver.takeNotes();
    const qsizetype before = site.blocks.size();
    site.device.reboot(site.line.time());
    site.turn();
    QVERIFY(site.last.conditions.testFlag(Condition::Rebooted));
    QCOMPARE(site.driver.takeNotes().size(), 1);
    site.run(60s);
    QVERIFY(!site.last.conditions.testFlag(Condition::Rebooted));
    QVERIFY(!(site.conditions & (Condition::SyncError | Condition::RingOverrun)));
    QVERIFY(!site.blocks.at(before).followsPrevious);
    QVERIFY(site.blocks.size() >= before + 18);
}

/// The sensor is silent for a second, then the new run is read from its first sample.
void TstAnd3Together::resetByCommand()
{
    Site site;
    site.run(60s);
    const qsizetype before = site.blocks.size();
    QVERIFY(site.line.exchange({Request::reset(17).toBytes(), answerTo(Request::reset(17))}));
    site.run(61s);
    QVERIFY(site.failures >= 1);
    QVERIFY(site.last.ring);
    QCOMPARE(site.last.ring->packetsMeasured, quint64(18));
    QVERIFY(!site.blocks.at(before).followsPrevious);
    QVERIFY(site.blocks.size() >= before + 18);
}

void TstAnd3Together::pausedRecordingIsResumed()
{
    Site site;
    site.run(60s);
    const Request stop = Request::mode(17, ModeBit::RecordingStopped, true);
    QVERIFY(site.line.exchange({stop.toBytes(), answerTo(stop)}));
    site.run(60s);
    QVERIFY(site.last.rawMode == quint16(0xCC00));
    QVERIFY(site.blocks.size() >= 36);
    for (const DriverNote &note : site.driver.takeNotes()) {
        QVERIFY(note.kind != JournalKind::Error || note.text.contains(QStringLiteral("follow")));
    }
}

QTEST_GUILESS_MAIN(TstAnd3Together)
#include "tst_and3together.moc"
