#include "core/devices/usmisn/usmisnprotocol.h"
#include "core/devices/usmisn/usmisnsimulator.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The simulator against what manual 002 says of the device, in the bytes that it prints.
class TstUsmisnSimulator : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answers_data();
    void answers();
    void measures();
    void stores();
    void memoryOverwritesTheOldest();
    void newRecordsOnce();
    void watchdog();
    void firstSecond();
    void sleepsAndMeasures();
    void wakesInItsSecond();
    void monthOfSleep();
    void survivesNoise();
};

namespace {

using Time = SimulatedDevice::Time;

constexpr quint64 seed = 7;

SensorConfig config()
{
    SensorConfig sensor;
    sensor.number = 1;
    sensor.address = 123;
    sensor.serialNumber = QStringLiteral("1234567");
    return sensor;
}

/// Bytes to a device that has been on for two seconds.
QByteArray say(Simulator &device, const QByteArray &bytes, Time now = 2s)
{
    return device.receive(bytes, now);
}

Value valueFrom(const QByteArray &answer, Instruction instruction = Instruction::GetValue)
{
    const Question question{123, "001", instruction};
    const Scan scan = scanAnswer(answer, question);
    return *decodeValue(answer.mid(scan.skip, scan.length), question);
}

} // namespace

void TstUsmisnSimulator::answers_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("answer");
    const auto row = [](const char *request, const char *answer) {
        QTest::newRow(request) << QByteArray(request) << QByteArray(answer);
    };
    row("%/Q/123/001/GetSerial//%", "\n%/R/123/001/GetSerial/01234567/%\r\n");
    row("%/Q/123/001/GetSerial//%%/Q/123/001/GetCRC//%",
        "\n%/R/123/001/GetSerial/01234567/%\r\n\n%/R/123/001/GetCRC/3002295620/%\r\n");
    row("%/Q/123/001/GetCRC//%", "\n%/R/123/001/GetCRC/0000000000/%\r\n");
    row("%/Q/123/001/GetType//%", "\n%/R/123/001/GetType/028/%\r\n");
    row("%/Q/123/001/GetProgVersion//%", "\n%/R/123/001/GetProgVersion/14.04.17/%\r\n");
    row("%/Q/123/001/GetDateCalibration//%", "\n%/R/123/001/GetDateCalibration/00000042839/%\r\n");
    row("%/Q/123/001/GetCountCalibration//%", "\n%/R/123/001/GetCountCalibration/00000000002/%\r\n");
    row("%/Q/123/001/GetInfo//%",
        "\n%/R/123/001/GetInfo/0123456701,A,Grad,Angle_X%\r\n\n%/R/123/001/GetInfo/0123456702,A,Grad,Angle_Y%\r\n"
        "\n%/R/123/001/GetInfo/End/%\r\n");
    row("%/Q/123/001/GetAddress//%", "\n%/R/123/001/GetAddress/123/%\r\n");
    row("%/Q/000/001/GetAddress//%", "\n%/R/000/001/GetAddress/123/%\r\n");
    row("%/Q/123/001/SetAddress/32/%", "\n%/R/123/001/SetAddress/32/%\r\n");
    row("%/Q/123/001/SetAddress/ABC/%", "\n%/R/123/001/SetAddress/ErrorData/%\r\n");
    row("%/Q/000/001/SetAddress/32/%", "");
    row("%/Q/123/001/SetPortSettings/19200,N,1/%", "\n%/R/123/001/SetPortSettings/19200,N,1/%\r\n");
    row("%/Q/123/001/SetPortSettings/0,0,0/%", "\n%/R/123/001/SetPortSettings/ErrorData/%\r\n");
    row("%/Q/000/001/SetPortSettings/19200,N,1/%", "");
    row("%/Q/123/001/ResetPortSettings//%", "\n%/R/123/001/ResetPortSettings//%\r\n");
    row("%/Q/000/001/ResetPortSettings//%", "");
    row("%/Q/123/001/GetValue/0,3/%", "\n%/R/123/001/GetValue/ErrorCH/%\r\n");
    row("%/Q/123/001/GetValue/1/%", "\n%/R/123/001/GetValue/ErrorData/%\r\n");
    row("%/Q/0/001/GetValue/0,123456801/%", "");
    row("%/Q/123/001/GetRecord/1,NEW,1/%", "\n%/R/123/001/GetRecord/End/%\r\n");
    row("%/Q/123/001/GetRecord/1/%", "\n%/R/123/001/GetRecord/ErrorData/%\r\n");
    row("%/Q/0/001/GetRecord/1,ALL,123456801/%", "");
    row("%/Q/123/001/StartCycle/1483267255,1483267265,3600,30/%",
        "\n%/R/123/001/StartCycle/1483267255,1483267265,3600,30/%\r\n");
    row("%/Q/0/001/StartCycle/1483267255,1483267265,3600,30/%", "");
    row("%/Q/123/001/StartCycle/1483267255,1483267265,0,30/%", "\n%/R/123/001/StartCycle/ErrorData/%\r\n");
    row("%/Q/123/001/StartCycle/1/%", "\n%/R/123/001/StartCycle/ErrorData/%\r\n");
    row("%/Q/123/001/StopCycle//%", "\n%/R/123/001/StopCycle//%\r\n");
    row("%/Q/0/001/StopCycle//%", "");
    row("%/Q/0/001/GetSerial//%", "");
    row("%/Q/0/001/GetInfo//%", "");
    row("%/Q/124/001/GetSerial//%", "");
    row("%/R/123/001/GetSerial//%", "");
    row("%/Q/123/001/GetSerial/", "");
}

void TstUsmisnSimulator::answers()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);
    Simulator whole(config(), seed);
    QCOMPARE(say(whole, request), answer);
    Simulator bytewise(config(), seed);
    QByteArray pieces;
    for (const char byte : request) {
        pieces += say(bytewise, QByteArray(1, byte));
    }
    QCOMPARE(pieces, answer);
}

void TstUsmisnSimulator::measures()
{
    Simulator sensor(config(), seed);
    const QByteArray answer = say(sensor, "%/Q/123/001/GetValue/0,1/%", 5s);
    QVERIFY(answer.startsWith("\n%/R/123/001/GetValue/00000000000,00123456701,00000000000,"));
    QVERIFY(answer.endsWith(",A,Grad,Angle_X,001,5/%\r\n"));
    const double tilt = BuildingMotion(seed, 1).tiltX(5s);
    QVERIFY(std::abs(valueFrom(answer).value * 3600 - tilt) < 0.02); // a hundred thousandth of a degree is 0.036″
    QVERIFY(sensor.workTime() > 1089ms && sensor.workTime() < 1500ms);
    QVERIFY(!say(sensor, "%/Q/0/001/GetValue/0,123456702/%", 6s).isEmpty());
    say(sensor, "%/Q/123/001/GetType//%", 7s);
    QVERIFY(sensor.workTime() < 50ms);

    sensor.setOutOfRange(true);
    QVERIFY(say(sensor, "%/Q/123/001/GetValue/0,1/%", 8s).contains(",OutOfRange,"));
    sensor.setBroken(true);
    QCOMPARE(say(sensor, "%/Q/123/001/GetValue/0,1/%", 9s), QByteArray("\n%/R/123/001/GetValue/ErrorSensor/%\r\n"));
}

void TstUsmisnSimulator::stores()
{
    Simulator sensor(config(), seed);
    say(sensor, "%/Q/123/001/GetValue/0,1/%", 3s);
    QCOMPARE(sensor.memory().size(), 0);
    const Value value = valueFrom(say(sensor, "%/Q/123/001/GetValue/1483267255,1/%", 5s));
    QCOMPARE(value.timestamp, 1483267255);
    QCOMPARE(value.measurement, 1U);
    say(sensor, "%/Q/123/001/GetValue/1483267256,2/%", 6s);
    QCOMPARE(sensor.memory().size(), 2);
    const QByteArray records = say(sensor, "%/Q/123/001/GetRecord/0,ALL,1/%", 7s);
    QCOMPARE(records.count("\n%/R"), 2);
    const Value record = valueFrom(records, Instruction::GetRecord);
    QCOMPARE(record.value, value.value);
    QCOMPARE(record.timestamp, value.timestamp);
}

void TstUsmisnSimulator::memoryOverwritesTheOldest()
{
    Simulator sensor(config(), seed);
    sensor.overrunRing(1s);
    QCOMPARE(sensor.memory().size(), qsizetype(memorySize));
    say(sensor, "%/Q/123/001/GetValue/1483267255,1/%", 5s);
    QCOMPARE(sensor.memory().size(), qsizetype(memorySize));
    const QByteArray records = say(sensor, "%/Q/123/001/GetRecord/0,ALL,1/%", 7s);
    QCOMPARE(records.count("\n%/R"), memorySize / 2 + 1); // the first of X made room for the new one
    QCOMPARE(valueFrom(records, Instruction::GetRecord).measurement, 3U);
}

void TstUsmisnSimulator::newRecordsOnce()
{
    Simulator sensor(config(), seed);
    for (int i = 1; i <= 3; ++i) {
        say(sensor, "%/Q/123/001/GetValue/" + QByteArray::number(1483267250 + i) + ",1/%", i * 3s);
    }
    const QByteArray last = say(sensor, "%/Q/123/001/GetRecord/1,NEW,1/%", 10s);
    QCOMPARE(valueFrom(last, Instruction::GetRecord).measurement, 3U);
    const QByteArray rest = say(sensor, "%/Q/123/001/GetRecord/0,NEW,1/%", 11s);
    QCOMPARE(rest.count("\n%/R"), 3);
    QCOMPARE(say(sensor, "%/Q/123/001/GetRecord/0,NEW,1/%", 12s), QByteArray("\n%/R/123/001/GetRecord/End/%\r\n"));
    QCOMPARE(say(sensor, "%/Q/123/001/GetRecord/2,ALL,1/%", 13s).count("\n%/R"), 3);
}

/// Any message feeds it, also one that means nobody.
void TstUsmisnSimulator::watchdog()
{
    Simulator fed(config(), seed);
    for (int i = 1; i <= 100; ++i) {
        say(fed, "%/anything/%", i * 25s);
    }
    QCOMPARE(fed.resets(), 0);
    Simulator hungry(config(), seed);
    say(hungry, "7E 9B 01 01 9B 7E", 20s);
    say(hungry, "%/unfinished", 25s);
    say(hungry, "", 27s);
    QCOMPARE(hungry.resets(), 1);
    say(hungry, "", 26s * 4 + 1s);
    QCOMPARE(hungry.resets(), 4);
}

/// 9600-N-1 after each start, whatever it was set to.
void TstUsmisnSimulator::firstSecond()
{
    Simulator sensor(config(), seed);
    sensor.hostSpeaks({19200, Parity::None, StopBits::One}); // what it is set up for
    const QByteArray ask = "%/Q/123/001/GetType//%";
    QVERIFY(say(sensor, ask, 50ms).isEmpty());
    QVERIFY(say(sensor, ask, 500ms).isEmpty());
    QVERIFY(!say(sensor, ask, 1200ms).isEmpty());
    sensor.hostSpeaks(factoryPort);
    QVERIFY(say(sensor, ask, 3s).isEmpty());
    sensor.reboot(10s);
    QVERIFY(!say(sensor, ask, 10500ms).isEmpty());
    QVERIFY(!say(sensor, "%/Q/123/001/ResetPortSettings//%", 10900ms).isEmpty());
    QVERIFY(!say(sensor, ask, 12s).isEmpty());
}

void TstUsmisnSimulator::sleepsAndMeasures()
{
    Simulator sensor(config(), seed);
    QVERIFY(!say(sensor, "%/Q/123/001/StartCycle/1483267255,1483267265,900,30/%", 2s).isEmpty());
    QVERIFY(sensor.isRecording());
    QVERIFY(say(sensor, "%/Q/123/001/GetType//%", 12s).isEmpty());
    say(sensor, "", 2s + 39s);
    QCOMPARE(sensor.memory().size(), 0);
    say(sensor, "", 2s + 40s); // ten seconds to the start, thirty of delay
    QCOMPARE(sensor.memory().size(), 2);
    say(sensor, "", 2s + 40s + 900s);
    QCOMPARE(sensor.memory().size(), 4);
}

void TstUsmisnSimulator::wakesInItsSecond()
{
    const QByteArray stop = "%/Q/123/001/StopCycle//%";
    Simulator sensor(config(), seed);
    say(sensor, "%/Q/123/001/StartCycle/1483267255,1483267265,900,0/%", 2s);
    Time wokenAt{0};
    for (Time now = 2500ms; now < 122s && wokenAt == Time(0); now += 500ms) {
        wokenAt = say(sensor, stop, now).isEmpty() ? Time(0) : now;
    }
    QVERIFY(wokenAt >= 28s && wokenAt < 29s);
    QVERIFY(!sensor.isRecording());
    QVERIFY(!say(sensor, "%/Q/123/001/GetType//%", wokenAt + 1s).isEmpty());
}

/// 30 days, every hour, both channels.
void TstUsmisnSimulator::monthOfSleep()
{
    Simulator sensor(config(), seed);
    say(sensor, "%/Q/123/001/StartCycle/1483267255,1483267256,3600,0/%", 2s);
    const Time waking = 2s + 26s * 99693; // the 30th day
    QVERIFY(!say(sensor, "%/Q/123/001/StopCycle//%", waking).isEmpty());
    QCOMPARE(sensor.memory().size(), 2 * 721); // at both ends
    const QByteArray records = say(sensor, "%/Q/123/001/GetRecord/0,ALL,2/%", waking + 1s);
    QCOMPARE(records.count("\n%/R"), 721 + 1);
    QCOMPARE(valueFrom(records, Instruction::GetRecord).timestamp, 1483267256);
}

void TstUsmisnSimulator::survivesNoise()
{
    Simulator sensor(config(), seed);
    const QByteArray ask = "%/Q/123/001/GetType//%";
    QVERIFY(!say(sensor, QByteArray("\x00\xFF%%/%/Q/12%\r\n/%", 15) + ask).isEmpty());
    QVERIFY(!say(sensor, "%/" + QByteArray(5000, 'x') + ask).isEmpty());
    QVERIFY(!say(sensor, "%/Q/123/001/" + ask).isEmpty());
}

QTEST_GUILESS_MAIN(TstUsmisnSimulator)
#include "tst_usmisnsimulator.moc"
