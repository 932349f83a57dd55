#include "core/devices/drivercatalog.h"
#include "core/engine/linepoller.h"
#include "core/engine/polledsensor.h"
#include "core/simulation/simulatedline.h"
#include "core/values/readingjson.h"
#include "tests/support/fakeline.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// A line of УСМ-ИСН, whose watchdogs have to be fed, in the engine: what becomes of their answers, and what is said when there
/// is nothing to say.
class TestWatchedLine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readings_data();
    void readings();
    void fedBetweenCyclesAndInService();
    void silencedForAHangingDevice();
};

namespace {

PollingSettings settings(int sensors)
{
    PollingSettings settings;
    settings.line.index = 1;
    settings.line.isOn = true;
    settings.line.baudRate = 115200;
    for (int i = 1; i <= sensors; ++i) {
        SensorConfig sensor;
        sensor.number = i;
        sensor.index = i;
        sensor.address = i;
        sensor.isOn = true;
        sensor.type = SensorType::UsmIsn;
        sensor.model = QStringLiteral("USM-ISN");
        sensor.measuresTilt = true;
        settings.line.sensors.append(sensor);
    }
    return settings;
}

QByteArray answer(const char *transaction, const QByteArray &fields)
{
    return QByteArray("\n%/R/1/") + transaction + "/GetValue/" + fields + "/%\r\n";
}

} // namespace

void TestWatchedLine::readings_data()
{
    QTest::addColumn<QByteArray>("x");
    QTest::addColumn<int>("code");
    QTest::addColumn<bool>("isTiltGood");
    const QByteArray good = "0,00123456701,0,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5";
    QTest::newRow("good") << good << 0 << true;
    QTest::newRow("out of range") << QByteArray(good).replace("-0002.48289", "OutOfRange") << 7 << false;
    QTest::newRow("sensor") << QByteArray("ErrorSensor") << 5 << false;
    QTest::newRow("channel") << QByteArray("ErrorCH") << 0 << false;
    QTest::newRow("data") << QByteArray("ErrorData") << 0 << false;
}

void TestWatchedLine::readings()
{
    QFETCH(QByteArray, x);
    QFETCH(int, code);
    QFETCH(bool, isTiltGood);
    const PollingSettings site = settings(1);
    const SensorConfig &config = site.line.sensors.first();
    DriverSettings driver;
    driver.sensor = config;
    PolledSensor sensor(makeDriver(driver), {});
    sensor.lineBecame(LineState::Open);
    FakeLine line;
    line.expect("%/Q/1/001/GetType//%", "\n%/R/1/001/GetType/028/%\r\n")
        .expect("%/Q/1/002/GetValue/0,1/%", answer("002", x));
    line.expect(
        "%/Q/1/003/GetValue/0,2/%", answer("003", "0,00123456702,0,0001.00000,0000.00010,26.33,A,Grad,Angle_Y,001,5"));
    QVERIFY(sensor.poll(line));
    const Reading &reading = sensor.reading();
    QCOMPARE(int(statusCode(reading.status)), code);
    QCOMPARE(isTiltValid(reading.status), isTiltGood);
    const QJsonObject json = QJsonDocument::fromJson(readingToJson(reading, config, site.line)).object();
    QCOMPARE(json.value(QStringLiteral("type")).toString(), QStringLiteral("USM-ISN"));
    for (const char *key : {"tiltX", "tiltY", "variationX", "variationY"}) {
        QCOMPARE(json.contains(QLatin1String(key)), isTiltGood);
    }
    if (isTiltGood) {
        QVERIFY(qAbs(json.value(QStringLiteral("tiltX")).toDouble() + 8938.404) < 1e-6);
        QCOMPARE(json.value(QStringLiteral("variationX")).toDouble(), 0.0086);
        QCOMPARE(json.value(QStringLiteral("variationY")).toDouble(), 0.0001);
    }
}

/// The next cycle is an hour away; nothing is said until the watchdog has to be fed, while polling and in service alike.
void TestWatchedLine::fedBetweenCyclesAndInService()
{
    PollingSettings site = settings(1);
    site.timing.run = 1h;
    SimulatedBus::Options options;
    SimulatedLine line(site.line, options, std::chrono::steady_clock::now() - 5s, 100ms);
    QVERIFY(line.open());
    LinePoller poller(site);
    poller.restart();
    TurnReport report = poller.turn(line);
    QCOMPARE(report.readings.size(), 1);
    QVERIFY(report.readings.first().isAnswer);
    report = poller.turn(line);
    const auto wait = report.nextAt - std::chrono::steady_clock::now();
    QVERIFY(wait > 5s && wait <= 10s);
    const quint64 before = line.bytesSent();
    QTest::qWait(int(std::chrono::ceil<std::chrono::milliseconds>(wait).count()));
    report = poller.turn(line);
    QVERIFY(report.readings.isEmpty() && !report.lineFault);
    QCOMPARE(line.bytesSent() - before, quint64(QByteArray("%/Q/0/000/GetSerial//%").size()));
    QVERIFY(poller.keepAwake(line)); // it was fed just now
    QCOMPARE(line.bytesSent() - before, quint64(QByteArray("%/Q/0/000/GetSerial//%").size()));
}

/// Once, however many devices hang.
void TestWatchedLine::silencedForAHangingDevice()
{
    PollingSettings site = settings(2);
    site.timing.readCommand = 1ms;
    site.timing.run = 1ms;
    site.timing.readErrorLimit = 2;
    site.rules.readErrorLimit = 2;
    SimulatedBus::Options options;
    options.faults.append(*parseSimulatedFault(QStringLiteral("silent=1")));
    options.faults.append(*parseSimulatedFault(QStringLiteral("silent=2")));
    SimulatedLine line(site.line, options, std::chrono::steady_clock::now() - 5s, 100ms);
    QVERIFY(line.open());
    LinePoller poller(site);
    poller.restart();
    TurnReport report;
    int words = 0;
    for (int i = 0; i < 4 && words == 0; ++i) {
        QTest::qWait(int(std::max<qint64>((report.nextAt - std::chrono::steady_clock::now()) / 1ms, 0)) + 1);
        report = poller.turn(line);
        words += std::count_if(report.events.begin(), report.events.end(), [](const TurnReport::Event &event) {
            return event.text.contains(QStringLiteral("30"));
        });
    }
    QCOMPARE(words, 1);
    const quint64 sent = line.bytesSent();
    report = poller.turn(line);
    QCOMPARE(line.bytesSent(), sent);
    const auto silence = report.nextAt - std::chrono::steady_clock::now();
    QVERIFY(silence > 15s && silence <= 30s);
}

QTEST_GUILESS_MAIN(TestWatchedLine)
#include "tst_watchedline.moc"
