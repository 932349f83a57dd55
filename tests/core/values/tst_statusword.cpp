#include "core/values/statusword.h"

#include <QTest>

using namespace gorizont;

namespace {

SensorConfig anD3()
{
    SensorConfig sensor;
    sensor.type = SensorType::AnD3;
    sensor.isOn = true;
    sensor.measuresTilt = true;
    sensor.measuresTemperature = true;
    sensor.measuresAcceleration = true;
    return sensor;
}

SensorConfig heatedAnD3()
{
    SensorConfig sensor = anD3();
    sensor.hasThermostat = true;
    return sensor;
}

SensorConfig inD3()
{
    SensorConfig sensor;
    sensor.type = SensorType::InD;
    sensor.isOn = true;
    sensor.measuresTilt = true;
    return sensor;
}

/// Everything answered, nothing wrong.
SensorSituation good()
{
    SensorSituation situation;
    situation.line = LineState::Open;
    situation.hasAnswered = true;
    situation.hasTilt = true;
    situation.hasTemperature = true;
    situation.hasAcceleration = true;
    return situation;
}

SensorSituation onLine(LineState state)
{
    SensorSituation situation = good();
    situation.line = state;
    return situation;
}

SensorSituation failing(int readErrors, int crcErrors)
{
    SensorSituation situation = good();
    situation.readErrorsInRow = readErrors;
    situation.crcErrorsInRow = crcErrors;
    return situation;
}

SensorSituation with(Conditions conditions, std::optional<double> heaterPower = {})
{
    SensorSituation situation = good();
    situation.conditions = conditions;
    situation.heaterPower = heaterPower;
    return situation;
}

LineStatus line(int port, LineState state)
{
    LineStatus status;
    status.port = port;
    status.state = state;
    return status;
}

} // namespace

Q_DECLARE_METATYPE(SensorConfig)
Q_DECLARE_METATYPE(SensorSituation)

/// Manual 000, section 11; spec/gorizont.md, section 5. Expected words are written from those tables.
class TestStatusWord : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void firstRowDecides_data();
    void firstRowDecides();
    void conditionsBecomeCodesAndFlags_data();
    void conditionsBecomeCodesAndFlags();
    void limitsComeFromTheIni();
    void legacyBitsGiveTheSampleLines();
    void initialWords();
    void channelWordHasTwoBitsAPort();
};

void TestStatusWord::firstRowDecides_data()
{
    QTest::addColumn<SensorSituation>("situation");
    QTest::addColumn<bool>("isOn");
    QTest::addColumn<int>("expected");

    QTest::newRow("sensor off") << good() << false << 0x0F00;
    QTest::newRow("sensor off on a port that is off") << onLine(LineState::Off) << false << 0x0F00;
    QTest::newRow("port off") << onLine(LineState::Off) << true << 0x1700;
    QTest::newRow("port cannot be opened") << onLine(LineState::OpenFailed) << true << 0x2700;
    QTest::newRow("port lost") << onLine(LineState::Lost) << true << 0x2700;
    SensorSituation lost = failing(10, 10);
    lost.line = LineState::Lost;
    QTest::newRow("port lost before errors") << lost << true << 0x2700;
    QTest::newRow("CRC errors") << failing(0, 10) << true << 0x4700;
    QTest::newRow("CRC errors before read errors") << failing(10, 10) << true << 0x4700;
    QTest::newRow("read errors") << failing(10, 9) << true << 0x3700;
    QTest::newRow("one error less") << failing(9, 9) << true << 0x0000;

    SensorSituation silent = good();
    silent.hasAnswered = false;
    QTest::newRow("no answer yet") << silent << true << 0x0700;
    silent.readErrorsInRow = 10;
    QTest::newRow("never answered") << silent << true << 0x3700;
    QTest::newRow("opening") << onLine(LineState::Opening) << true << 0x0700;
    QTest::newRow("service mode") << onLine(LineState::Service) << true << 0x0700;
    SensorSituation served = failing(10, 0);
    served.line = LineState::Service;
    QTest::newRow("read errors before service mode") << served << true << 0x3700;
    QTest::newRow("answering") << good() << true << 0x0000;
}

void TestStatusWord::firstRowDecides()
{
    QFETCH(SensorSituation, situation);
    QFETCH(bool, isOn);
    QFETCH(int, expected);
    SensorConfig sensor = anD3();
    sensor.isOn = isOn;
    QCOMPARE(static_cast<int>(sensorWord(sensor, situation, {})), expected);
}

void TestStatusWord::conditionsBecomeCodesAndFlags_data()
{
    using enum Condition;
    QTest::addColumn<SensorConfig>("sensor");
    QTest::addColumn<SensorSituation>("situation");
    QTest::addColumn<int>("expected");

    QTest::newRow("transducer silent") << anD3() << with(TransducerSilent) << 0x5400;
    QTest::newRow("transducer CRC") << anD3() << with(TransducerCrc) << 0x6400;
    QTest::newRow("transducer range") << anD3() << with(TransducerRange) << 0x7400;
    QTest::newRow("temperature read") << anD3() << with(TemperatureReadError) << 0x8200;
    QTest::newRow("temperature range") << anD3() << with(TemperatureRange) << 0x9200;
    QTest::newRow("fan without thermostat") << anD3() << with(FanError) << 0x0000;
    QTest::newRow("thermostat without thermostat") << anD3() << with(ThermostatError, 0) << 0x0000;
    QTest::newRow("fan") << heatedAnD3() << with(FanError) << 0xA000;
    QTest::newRow("thermostat") << heatedAnD3() << with(ThermostatError) << 0xB000;
    QTest::newRow("fan before thermostat") << heatedAnD3() << with(FanError | ThermostatError) << 0xA000;
    QTest::newRow("lower code wins, both flags") << anD3() << with(TransducerCrc | TemperatureRange) << 0x6600;
    QTest::newRow("bit 9 beside code 5") << heatedAnD3() << with(TransducerSilent | TemperatureReadError | FanError)
                                         << 0x5600;

    QTest::newRow("full power") << heatedAnD3() << with({}, 99.9) << 0x0014;
    QTest::newRow("nearly full power") << heatedAnD3() << with({}, 99.89) << 0x0000;
    QTest::newRow("half power") << heatedAnD3() << with({}, 50) << 0x0000;
    QTest::newRow("little power") << heatedAnD3() << with({}, 0.1) << 0x0000;
    QTest::newRow("no power") << heatedAnD3() << with({}, 0.09) << 0x0018;
    QTest::newRow("power unknown") << heatedAnD3() << with({}) << 0x0000;
    QTest::newRow("sample `10 0000 0001 0100`") << heatedAnD3() << with(FanError, 100) << 0xA014;

    QTest::newRow("tilt not ready") << anD3() << with(TiltNotReady) << 0x0400;
    QTest::newRow("temperature not ready") << anD3() << with(TemperatureNotReady) << 0x0200;
    SensorSituation early = good();
    early.hasAcceleration = false;
    QTest::newRow("acceleration not ready") << anD3() << early << 0x0100;
    QTest::newRow("ring overrun") << anD3() << with(RingOverrun) << 0x0180;
    QTest::newRow("sync error") << anD3() << with(SyncError) << 0x0140;
    QTest::newRow("rebooted") << anD3() << with(Rebooted) << 0x0720;
    QTest::newRow("ИН-Д3 has tilt alone") << inD3() << good() << 0x0300;
    SensorSituation blind = good();
    blind.hasTilt = false;
    QTest::newRow("answer without tilt") << inD3() << blind << 0x0700;
}

void TestStatusWord::conditionsBecomeCodesAndFlags()
{
    QFETCH(SensorConfig, sensor);
    QFETCH(SensorSituation, situation);
    QFETCH(int, expected);
    QCOMPARE(static_cast<int>(sensorWord(sensor, situation, {})), expected);
}

void TestStatusWord::limitsComeFromTheIni()
{
    const StatusRules rules{13, 3, false};
    QCOMPARE(sensorWord(anD3(), failing(12, 2), rules), quint16(0x0000));
    QCOMPARE(sensorWord(anD3(), failing(13, 2), rules), quint16(0x3700));
    QCOMPARE(sensorWord(anD3(), failing(12, 3), rules), quint16(0x4700));
}

void TestStatusWord::legacyBitsGiveTheSampleLines()
{
    const StatusRules rules{10, 10, true};
    // The sample of section 3: ИН-Д3 ` 0 0011 0011 1000`, АН-Д3 ` 0 0000 0001 1000`, both with heater power 0.0.
    QCOMPARE(sensorWord(inD3(), good(), rules), quint16(0x0338));
    QCOMPARE(sensorWord(anD3(), with({}, 0), rules), quint16(0x0018));
    QCOMPARE(sensorWord(anD3(), with({}, 50), rules), quint16(0x0000));
    QCOMPARE(sensorWord(inD3(), onLine(LineState::Off), rules), quint16(0x1700));
}

void TestStatusWord::initialWords()
{
    LineConfig port;
    SensorConfig sensor = anD3();
    port.isOn = true;
    QCOMPARE(initialSensorWord(port, sensor, {}), quint16(0x0700));
    port.isOn = false;
    QCOMPARE(initialSensorWord(port, sensor, {}), quint16(0x1700));
    sensor.isOn = false;
    QCOMPARE(initialSensorWord(port, sensor, {}), quint16(0x0F00));
}

void TestStatusWord::channelWordHasTwoBitsAPort()
{
    QCOMPARE(channelWord({}), 0U);
    QCOMPARE(channelWord({line(1, LineState::OpenFailed)}), 0x1U);
    QCOMPARE(channelWord({line(2, LineState::Lost)}), 0x8U);
    QCOMPARE(channelWord({line(16, LineState::Off)}), 0xC0000000U);
    QCOMPARE(channelWord({line(1, LineState::Open), line(2, LineState::Service), line(3, LineState::Opening)}), 0U);
    QCOMPARE(channelWord({line(1, LineState::Off), line(3, LineState::Lost), line(4, LineState::OpenFailed)}), 0x63U);
    QCOMPARE(channelWord({line(0, LineState::Off), line(17, LineState::Off)}), 0U);
}

QTEST_GUILESS_MAIN(TestStatusWord)

#include "tst_statusword.moc"
