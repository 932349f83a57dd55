#include "core/engine/linepoller.h"
#include "core/simulation/simulatedline.h"

#include <QTest>

#include <thread>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

/// An accelerometer (1) that has measured for five minutes and whose ring is full of packets, and an inclinometer (2).
PollingSettings settings(std::chrono::milliseconds run)
{
    PollingSettings settings;
    settings.line.index = 1;
    for (int i = 1; i <= 2; ++i) {
        SensorConfig sensor;
        sensor.number = i;
        sensor.index = i;
        sensor.address = i;
        sensor.isOn = true;
        sensor.type = i == 1 ? SensorType::AnD3 : SensorType::InD;
        sensor.measuresTilt = true;
        sensor.measuresAcceleration = i == 1;
        settings.line.sensors.append(sensor);
    }
    settings.timing.run = run;
    settings.timing.addressChange = 0ms;
    return settings;
}

std::unique_ptr<SimulatedLine> openLine(const PollingSettings &settings, const FaultPlan &faults = {})
{
    SimulatedBus::Options options;
    options.faults = faults;
    auto line = std::make_unique<SimulatedLine>(
        settings.line, options, std::chrono::steady_clock::now() - 300s, std::chrono::milliseconds(100));
    [[maybe_unused]] const auto opened = line->open();
    return line;
}

/// Takes the turns as they are due.
TurnReport nextTurn(LinePoller &poller, Line &line, const TurnReport &last)
{
    std::this_thread::sleep_until(last.nextAt);
    return poller.turn(line);
}

} // namespace

class TestLinePoller : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A capture is fetched in the free time between turns, which stay even, and is brought with its sensor's number.
    void capturesComeBetweenTheTurns()
    {
        PollingSettings site;
        site.line.index = 1;
        SensorConfig sensor;
        sensor.number = 9;
        sensor.index = 1;
        sensor.isOn = true;
        sensor.type = SensorType::LVims;
        sensor.options = {
            {QStringLiteral("captureevery"), QStringLiteral("1")},
            {QStringLiteral("capturechannels"), QStringLiteral("0")}};
        site.line.sensors = {sensor};
        site.timing.run = 200ms;
        site.timing.addressChange = 0ms;
        const auto line = openLine(site);
        LinePoller poller(site);
        poller.restart();
        TurnReport report;
        QList<SignalCapture> captures;
        int answers = 0;
        const SteadyTime start = SteadyTime::clock::now();
        while (captures.size() < 2) {
            QVERIFY(SteadyTime::clock::now() - start < 30s);
            report = nextTurn(poller, *line, report);
            QVERIFY(!report.lineFault);
            captures += report.captures;
            answers += static_cast<int>(report.readings.size());
        }
        const auto cycles = (SteadyTime::clock::now() - start) / site.timing.run;
        QCOMPARE(captures.first().number, 9);
        QCOMPARE(captures.first().codes.size(), 12800);
        QVERIFY2(answers >= cycles - 2, qPrintable(QString::number(answers)));
        QVERIFY(cycles >= 4);
    }

    void bulkDataHoldUpNobody()
    {
        const PollingSettings busy = settings(1ms);
        const auto line = openLine(busy);
        LinePoller poller(busy);
        poller.lineBecame(LineState::Open);
        poller.restart();
        int blocks = 0;
        int stepsInARow = 0;
        TurnReport report;
        for (int i = 0; i < 60; ++i) {
            report = nextTurn(poller, *line, report);
            QVERIFY(!report.lineFault);
            stepsInARow = report.blocks.isEmpty() ? 0 : stepsInARow + 1;
            QVERIFY(stepsInARow <= 1); // the line is wanted: one step, then somebody's turn
            blocks += static_cast<int>(report.blocks.size());
        }
        QVERIFY2(blocks >= 30, qPrintable(QString::number(blocks)));
    }

    void aFreeLineIsUsedForBulkData()
    {
        const PollingSettings calm = settings(1000ms);
        const auto line = openLine(calm);
        LinePoller poller(calm);
        poller.lineBecame(LineState::Open);
        poller.restart();
        int blocks = 0;
        int cycles = 0;
        TurnReport report;
        while (cycles < 2) {
            report = nextTurn(poller, *line, report);
            cycles += report.isCycleOver ? 1 : 0;
            blocks += static_cast<int>(report.blocks.size());
        }
        QVERIFY2(blocks >= 20, qPrintable(QString::number(blocks))); // in one second of an idle line
    }

    void aChangeOfTheCodeIsAnEvent()
    {
        PollingSettings strict = settings(1ms);
        strict.line.sensors.removeFirst();
        strict.rules = {1, 1, false};
        strict.timing.readCommand = 20ms;
        const auto line = openLine(strict, {*parseSimulatedFault(QStringLiteral("silent=2@0-301"))});
        LinePoller poller(strict);
        poller.lineBecame(LineState::Open);
        poller.restart();
        TurnReport report = poller.turn(*line);
        QCOMPARE(report.events.size(), 1);
        QCOMPARE(report.events.first().kind, JournalKind::Error);
        QCOMPARE(report.events.first().number, 2);
        QCOMPARE(report.readings.first().status, quint16(0x3700));
        QCOMPARE(poller.readErrors(), 1u);
        const SteadyTime parkedAt = std::chrono::steady_clock::now();
        do {
            report = nextTurn(poller, *line, report);
        } while (report.readings.isEmpty());
        QVERIFY(std::chrono::steady_clock::now() - parkedAt > 1900ms); // parked, not asked for two seconds
        QCOMPARE(report.events.first().kind, JournalKind::On);
        QCOMPARE(report.readings.first().status, quint16(0x0300));
    }

    void aLineThatIsGoneIsNoFaultOfTheSensor()
    {
        const PollingSettings any = settings(1ms);
        const auto line = openLine(any);
        LinePoller poller(any);
        poller.lineBecame(LineState::Open);
        poller.restart();
        line->close();
        const TurnReport report = poller.turn(*line);
        QVERIFY(report.lineFault == Fault::Closed);
        QVERIFY(report.readings.isEmpty() && report.events.isEmpty());
        QCOMPARE(poller.readErrors(), 0u);
    }

    void aLineWithoutSensorsWaits()
    {
        PollingSettings empty = settings(1000ms);
        empty.line.sensors.clear();
        const auto line = openLine(empty);
        LinePoller poller(empty);
        QVERIFY(poller.turn(*line).nextAt > std::chrono::steady_clock::now() + 500ms);
    }
};

QTEST_APPLESS_MAIN(TestLinePoller)
#include "tst_linepoller.moc"
