#include "tests/core/devices/and3frames.h"
#include "tests/core/engine/inisite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray noPeriod = "[Timers]\nTmRun=10000\n";

bool isNear(double value, double expected)
{
    return qAbs(value - expected) < 1e-6;
}

} // namespace

/// The keys of a sensor, and those of [Common] that change its reading: each from the file to what it does to an answer
/// (manual 000, section 5; spec/gorizont.md, sections 1, 2 and 5).
class TestSensorKeys : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void corrections_data();
    void corrections();
    void onDecidesWhoIsAsked();
    void adrIsAsked();
    void nIsTheNumberOfTheReading();
    void nameDecidesTheProtocol();
    void protocolIsTheDialect();
    void statusBits_data();
    void statusBits();
    void gravityIsTheScale_data();
    void gravityIsTheScale();
    void accelOnDecidesAboutPackets();
    void canInfoAsks();
};

void TestSensorKeys::corrections_data()
{
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("t");
    // spec/gorizont.md, section 2, by hand from X −3599.5, Y 2720.5, T 21.38.
    QTest::newRow("none") << QByteArray() << -3599.5 << 2720.5 << 21.38;
    QTest::newRow("Xo") << QByteArray("Xo1=100") << -3699.5 << 2720.5 << 21.38;
    QTest::newRow("Yo") << QByteArray("Yo1=-100,5") << -3599.5 << 2821.0 << 21.38;
    QTest::newRow("To") << QByteArray("To1=0.38") << -3599.5 << 2720.5 << 21.0;
    QTest::newRow("InvY") << QByteArray("InvY1=1") << -3599.5 << -2720.5 << 21.38;
    QTest::newRow("RotX") << QByteArray("RotX1=90") << 2720.5 << 3599.5 << 21.38;
    QTest::newRow("all") << QByteArray("Xo1=100\nYo1=-100\nTo1=-1\nInvY1=1\nRotX1=90") << -2820.5 << 3699.5 << 22.38;
}

void TestSensorKeys::corrections()
{
    QFETCH(QByteArray, keys);
    FakeLine line;
    line.expect(askAnD3, answerAnD3);
    const TurnReport report = startedPoller(settingsFrom(sensorsOf("AN-D3", 1, keys + '\n')))->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    const Reading reading = report.readings.value(0);
    QVERIFY(reading.tilt && reading.temperature);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, t);
    QVERIFY2(isNear(reading.tilt->x, x), qPrintable(QString::number(reading.tilt->x)));
    QVERIFY2(isNear(reading.tilt->y, y), qPrintable(QString::number(reading.tilt->y)));
    QVERIFY2(isNear(*reading.temperature, t), qPrintable(QString::number(*reading.temperature)));
}

/// Sensor 1 is off: the line hears of sensor 2 only.
void TestSensorKeys::onDecidesWhoIsAsked()
{
    FakeLine line;
    line.expect(hex("7E 9B 01 02 98 7E"), hex("7E 9B 01 02 6A 77 80 38 C2 00 FF 7E"));
    const TurnReport report = startedPoller(settingsFrom(sensorsOf("IN-D3", 2, "On1=0\n")))->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QCOMPARE(report.readings.value(0).number, 2);
    QVERIFY(report.isCycleOver);
}

void TestSensorKeys::adrIsAsked()
{
    FakeLine line;
    line.expect(hex("02 C9 00 00 CE D1"), QByteArray()); // spec/and3.md
    startedPoller(settingsFrom(sensorsOf("AN-D3", 1, "adr1=2\n")))->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
}

void TestSensorKeys::nIsTheNumberOfTheReading()
{
    FakeLine line;
    line.expect(askInD3, answerInD3);
    const TurnReport report = startedPoller(settingsFrom(sensorsOf("IN-D3", 1, "N1=4711\n")))->turn(line);
    QCOMPARE(report.readings.value(0).number, 4711);
}

void TestSensorKeys::nameDecidesTheProtocol()
{
    for (const char *name : {"Датчик (ИН-Д3)", "in-d3", "АН2, ИН–Д3"}) {
        FakeLine line;
        line.expect(askInD3, answerInD3);
        startedPoller(settingsFrom(sensorsOf(name)))->turn(line);
        QCOMPARE(line.complaints(), QByteArrayList());
    }
    for (const char *name : {"АН1 (АН-ДЗ, TMP05)", "an-d3"}) {
        FakeLine line;
        line.expect(askAnD3, answerAnD3);
        startedPoller(settingsFrom(sensorsOf(name)))->turn(line);
        QCOMPARE(line.complaints(), QByteArrayList());
    }
}

void TestSensorKeys::protocolIsTheDialect()
{
    FakeLine line;
    line.expect(hex("7E 9A 01 01 FE 7E"), hex("E2 7C 00 72 32 81 7D")); // spec/ind3.md, protocol 2.10
    const TurnReport report = startedPoller(settingsFrom(sensorsOf("IN-D3", 1, "Protocol1=2.10\n")))->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QVERIFY(report.readings.value(0).tilt.has_value());
}

void TestSensorKeys::statusBits_data()
{
    QTest::addColumn<QByteArray>("ini");
    QTest::addColumn<quint16>("word");
    // Heater power 0, rebooted: bit 5 makes everything invalid.
    QTest::newRow("plain") << sensorsOf("AN-D3") << quint16(0b0000'0111'0010'0000);
    QTest::newRow("LegacyStatusBits") << "[Common]\nNumOfPorts=1\nLegacyStatusBits=1\n" + sensorsOf("AN-D3")
                                      << quint16(0b0000'0111'0011'1000);
    // The fan error of this sensor counts, and so does its heater: code A, bits 3 and 4.
    QTest::newRow("подогрев") << sensorsOf("АН-Д3 подогрев") << quint16(0b1010'0111'0011'1000);
}

void TestSensorKeys::statusBits()
{
    QFETCH(QByteArray, ini);
    FakeLine line;
    line.expect(askAnD3, hex("01 C9 84 8F 04 55 E1 14 00 00 00 00 0E 24 05 00 00 00 00 CC 10 FE"));
    line.expect(hex("01 32 65 01 4F BD"), hex("01 32 2F 38"));
    const TurnReport report = startedPoller(settingsFrom(ini))->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QTEST(report.readings.value(0).status, "word");
}

void TestSensorKeys::gravityIsTheScale_data()
{
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<double>("scale"); // mm/s² of 1/8 arc-second
    QTest::newRow("default") << QByteArray() << -0.00594713;
    QTest::newRow("Gravity") << QByteArray("Gravity=10\n") << -0.00606017;
}

void TestSensorKeys::gravityIsTheScale()
{
    QFETCH(QByteArray, keys);
    FakeLine line;
    line.expect(askAnD3, complexReadAnswer(32)).expect(sealed({1, 203, 0, 1}), packetsAnswer(0, 1));
    const auto poller = startedPoller(settingsFrom("[Common]\nNumOfPorts=1\n" + keys + noPeriod + sensorsOf("AN-D3")));
    poller->turn(line);
    const TurnReport report = poller->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QCOMPARE(report.blocks.size(), 1);
    QFETCH(double, scale);
    QVERIFY2(qAbs(report.blocks.first().scale - scale) < 5e-9, qPrintable(QString::number(report.blocks[0].scale)));
}

void TestSensorKeys::accelOnDecidesAboutPackets()
{
    FakeLine line;
    line.expect(askAnD3, complexReadAnswer(32));
    const auto poller = startedPoller(settingsFrom(noPeriod + sensorsOf("AN-D3", 1, "AccelOn1=0\n")));
    poller->turn(line);
    const TurnReport idle = poller->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QVERIFY(idle.blocks.isEmpty());
}

/// Asked in the free time of the cycle; site number 10 asks first thing.
void TestSensorKeys::canInfoAsks()
{
    for (const bool canInfo : {false, true}) {
        FakeLine line;
        line.expect(askAnD3, complexReadAnswer(0));
        if (canInfo) {
            line.expect(hex("01 24 04 00 B6 64"), hex("01 24 0C 03 02 00 02 BA"));
        }
        const QByteArray common = "[Common]\nNumOfPorts=1\nCanInfo=" + QByteArray::number(int(canInfo)) + '\n';
        const auto poller = startedPoller(settingsFrom(common + noPeriod + sensorsOf("AN-D3", 1, "N1=10\n")));
        QVERIFY(!poller->turn(line).information);
        const TurnReport idle = poller->turn(line);
        QVERIFY(line.isDone() && line.complaints().isEmpty());
        QCOMPARE(idle.information.has_value(), canInfo);
        if (canInfo) {
            QCOMPARE(idle.information->number, 10);
            QCOMPARE(idle.information->firmware, QStringLiteral("2.3.12"));
        }
    }
}

QTEST_APPLESS_MAIN(TestSensorKeys)
#include "tst_sensorkeys.moc"
