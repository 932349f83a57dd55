#include "core/config/sensorkey.h"
#include "tests/core/config/configreading.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

class TestServerConfig : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTheExampleOfTheManual_data();
    void readsTheExampleOfTheManual();
    void bothEncodingsOfTheExampleAreEqual();
    void absentKeysHaveTheirDefaults();
    void readsEveryKeyOfTheProgram();
    void readsEveryKeyOfALine();
    void readsEveryKeyOfASensor();
    void takesTheIndexOffAKey_data();
    void takesTheIndexOffAKey();
    void setsCapabilitiesByType();
    void clockOfAStationIsThatOfSensorPortOrSite();
    void aSensorDecidesBeforeTheSite();
};

void TestServerConfig::readsTheExampleOfTheManual_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("Windows-1251") << u"annex-cp1251.ini"_s;
    QTest::newRow("UTF-8") << u"annex-utf8.ini"_s;
}

void TestServerConfig::readsTheExampleOfTheManual()
{
    QFETCH(QString, name);
    const ConfigReading reading = read(dataFile(name));
    const ServerConfig &config = reading.config;
    QCOMPARE(config.caption, u"Gorizont Server"_s);
    QCOMPARE(config.name, u"GorizontServer"_s);
    QVERIFY(!config.closesSilently);
    QCOMPARE(config.timing.start, 100ms);
    QCOMPARE(config.timing.save, 10000ms);
    QCOMPARE(config.timing.exitLimit, 10000ms);
    QCOMPARE(config.timing.crcErrorPause, 600ms);
    QCOMPARE(config.timing.readCommand, 1000ms);
    QCOMPARE(config.timing.writeData, 200ms);
    QCOMPARE(config.timing.readErrorLimit, 13);

    QStringList lines;
    for (const LineConfig &line : config.lines) {
        lines.append(
            u"%1 %2 %3 %4 %5"_s.arg(line.index).arg(line.title()).arg(line.baudRate).arg(line.isOn).arg(line.name));
    }
    QCOMPARE(
        lines,
        (QStringList{
            u"1 COM10 115200 1 Муха NPort"_s, u"2 COM9 9600 1 Муха UPort 1150"_s, u"3 COM2 115200 1 Муха Nport AN-D3"_s,
            u"4 COM4 9600 1 Муха UPort 1150"_s}));
    const QString all = u"tilt temperature acceleration"_s;
    QCOMPARE(
        sensorTexts(config),
        (QStringList{
            u"port 1 sensor 1: N 1, adr 1, on, AN-D3, SND3 365, "_s + all,
            u"port 1 sensor 2: N 2, adr 2, on, AN-D3, SND3 366, "_s + all,
            u"port 2 sensor 1: N 3, adr 11, on, IN-D3, SND3 5264, tilt"_s,
            u"port 2 sensor 2: N 4, adr 1, on, IN-D3, SND3 5422, tilt"_s,
            u"port 3 sensor 1: N 11, adr 4, on, AN-D3, SND3 367, "_s + all,
            u"port 3 sensor 2: N 12, adr 5, on, AN-D3, SND3 368, "_s + all,
            u"port 4 sensor 1: N 13, adr 28, on, IN-D3, SND3 5575, tilt"_s,
            u"port 4 sensor 2: N 14, adr 29, on, IN-D3, SND3 5581, tilt"_s}));
    QCOMPARE(
        complaintTexts(reading),
        (QStringList{
            u"[Port2] NumOfSensors, line 114: NumOfSensors is 8, but these have neither adr nor Name: 3, 4, 5, 6, 7, "
            "8. They are left out."_s,
            u"[Port4] NumOfSensors, line 197: NumOfSensors is 8, but these have neither adr nor Name: 3, 4, 5, 6, 7, "
            "8. They are left out."_s}));
}

void TestServerConfig::bothEncodingsOfTheExampleAreEqual()
{
    const ConfigReading old = read(dataFile(u"annex-cp1251.ini"_s));
    const ConfigReading utf8 = read(dataFile(u"annex-utf8.ini"_s));
    QVERIFY(old.config == utf8.config);
    QCOMPARE(old.complaints, utf8.complaints);
    QCOMPARE(old.config.lines.size(), 4);
}

void TestServerConfig::absentKeysHaveTheirDefaults()
{
    // The table of spec/gorizont.md, section 1, value by value.
    const ConfigReading reading = read("[Common]\nNumOfPorts=1\n[Port1]\nNumOfSensors=3\nName2=ИН-Д3\nName3=ИН-Д3\n");
    QCOMPARE(complaintTexts(reading).size(), 1); // sensor 1 is not listed
    const ServerConfig &config = reading.config;
    QCOMPARE(config.modbusPort, 502);
    QCOMPARE(config.adc24Port, 503);
    QCOMPARE(config.allowsCopy, false);
    QCOMPARE(config.closesSilently, true);
    QCOMPARE(config.startsHidden, false);
    QCOMPARE(config.savesFiles, true);
    QCOMPARE(config.asksInformation, false);
    QCOMPARE(config.servesOpc, false);
    QCOMPARE(config.servesModbus, true);
    QCOMPARE(config.servesAdc24, true);
    QCOMPARE(config.adc24Sensor, 0);
    QCOMPARE(config.adc24Axis, Adc24Axis::X);
    QCOMPARE(config.memoCount, 60);
    QCOMPARE(config.memoDelete, 1);
    QCOMPARE(config.ringPackets, 8192);
    QCOMPARE(config.packetsToSave, 1);
    QCOMPARE(config.gravity, 9.81347);
    QCOMPARE(config.modbusPacking, ModbusPacking::ByType);
    QCOMPARE(config.modbusBase, 0);
    QCOMPARE(config.hasLegacyStatusBits, false);

    const LineConfig &line = config.lines.at(0);
    QCOMPARE(line.baudRate, 115200);
    QCOMPARE(line.isOn, false);
    QCOMPARE(line.com, 1);
    QCOMPARE(line.sensors.size(), 2);
    QCOMPARE(line.sensors.at(0).isOn, false);
    QCOMPARE(line.sensors.at(0).address, 1);
    QCOMPARE(line.sensors.at(0).number, 1);
    QCOMPARE(line.sensors.at(1).number, 2);

    const Timing &timing = config.timing;
    QCOMPARE(timing.updateInterval, 100ms);
    QCOMPARE(timing.run, 1000ms);
    QCOMPARE(timing.start, 1000ms);
    QCOMPARE(timing.save, 1000ms);
    QCOMPARE(timing.pauseTick, 100ms);
    QCOMPARE(timing.reopenPause, 5000ms);
    QCOMPARE(timing.closePause, 5000ms);
    QCOMPARE(timing.exitLimit, 1000ms);
    QCOMPARE(timing.addressChange, 16ms);
    QCOMPARE(timing.idle, 1ms);
    QCOMPARE(timing.readErrorPause, 0ms);
    QCOMPARE(timing.crcErrorPause, 600ms);
    QCOMPARE(timing.readCommand, 200ms);
    QCOMPARE(timing.writeCommand, 100ms);
    QCOMPARE(timing.readData, 4000ms);
    QCOMPARE(timing.writeData, 2000ms);
    QCOMPARE(timing.readErrorLimit, 10);
    QCOMPARE(timing.crcErrorLimit, 10);
    QVERIFY(read("[Common]\n").config.lines.isEmpty());
}

void TestServerConfig::readsEveryKeyOfTheProgram()
{
    const ConfigReading reading =
        read("[Common]\nCaption=c\nName=n\nSerialNumber=24607676\nLanguage=EN\nIPPort1=1502\nIPPort2=1503\n"
             "CanModbus=0\nCanADC24=0\nCanOPCDA=1\nShowAdvanced=1\nCanHide=1\nCanClose=0\nCanSave=0\nCanInfo="
             "1\nMemoCount=61\n"
             "MemoDel=2\nSrsBufSize=4096\nSrsBufToSave=3\nGravity=9,8155\nModbusPacking=bynumber\nModbusBase=1\n"
             "ModbusClients=5\nModbusIdle=7\nModbusBind=127.0.0.1\nModbusAllow=10.0.0.0/8; ::1,192.168.1.7\n"
             "LegacyStatusBits=1\n[ADC24]\nAxis=y\n"
             "[Timers]\nTmUpdateInt=1\nTmRun=2\nTmStart=3\nTmSave=4\n[Pauses]\nPPauseTick=5\nPReOpen=6\nPClose=7\n"
             "PExit=8\n[Sleeps]\nSAdrChange=9\nSIdle=10\nSRError=11\nSCRCErrors=12\n[TimeOuts]\nTORCom=13\n"
             "TOWCom=14\nTORDat=15\nTOWDat=16\n[Errors]\nNumRErrSrs=17\nNumCErrSrs=18\n");
    QCOMPARE(complaintTexts(reading), QStringList());
    ServerConfig expected;
    expected.caption = u"c"_s;
    expected.name = u"n"_s;
    expected.serialNumber = u"24607676"_s;
    expected.language = u"en"_s;
    expected.modbusPort = 1502;
    expected.adc24Port = 1503;
    expected.servesModbus = false;
    expected.servesAdc24 = false;
    expected.servesOpc = true;
    expected.showsAdvanced = true;
    expected.startsHidden = true;
    expected.closesSilently = false;
    expected.savesFiles = false;
    expected.asksInformation = true;
    expected.memoCount = 61;
    expected.memoDelete = 2;
    expected.ringPackets = 4096;
    expected.packetsToSave = 3;
    expected.gravity = 9.8155;
    expected.modbusPacking = ModbusPacking::ByNumber;
    expected.modbusBase = 1;
    expected.modbusClients = 5;
    expected.modbusIdle = 7s;
    expected.modbusBind = u"127.0.0.1"_s;
    expected.modbusAllow = QStringList{u"10.0.0.0/8"_s, u"::1"_s, u"192.168.1.7"_s};
    expected.hasLegacyStatusBits = true;
    expected.adc24Axis = Adc24Axis::Y;
    expected.timing = {1ms, 2ms, 3ms, 4ms, 5ms, 6ms, 7ms, 8ms, 9ms, 10ms, 11ms, 12ms, 13ms, 14ms, 15ms, 16ms, 17, 18};
    QVERIFY(reading.config.timing == expected.timing);
    QVERIFY(reading.config == expected);
    QVERIFY(read("[Common]\nCanCopy=1\n").config.allowsCopy);
}

void TestServerConfig::readsEveryKeyOfALine()
{
    const ConfigReading reading = readPort("Name=adapter (VXC-142; x)\nDevice=tcp://10.0.0.5:4001\nBaudRate=19200\n"
                                           "DataBits=7\nParity=e\nStopBits=1,5\nRS485=1\n");
    QCOMPARE(complaintTexts(reading), QStringList());
    LineConfig expected;
    expected.index = 1;
    expected.name = u"adapter (VXC-142; x)"_s;
    expected.com = 3;
    expected.device = u"tcp://10.0.0.5:4001"_s;
    expected.baudRate = 19200;
    expected.dataBits = 7;
    expected.parity = Parity::Even;
    expected.stopBits = StopBits::OneAndHalf;
    expected.isRs485 = true;
    expected.isOn = true;
    QVERIFY(reading.config.lines.at(0) == expected);
    QCOMPARE(readPort("Parity=O\n").config.lines.at(0).parity, Parity::Odd);
    QCOMPARE(readPort("Parity=M\n").config.lines.at(0).parity, Parity::Mark);
    QCOMPARE(readPort("Parity=S\n").config.lines.at(0).parity, Parity::Space);
    QCOMPARE(readPort("StopBits=1.5\n").config.lines.at(0).stopBits, StopBits::OneAndHalf);
    QCOMPARE(readPort("StopBits=2\n").config.lines.at(0).stopBits, StopBits::Two);
}

void TestServerConfig::readsEveryKeyOfASensor()
{
    const ConfigReading reading = readPort("NumOfSensors=10\nName1=ИН-Д3, ось; 1\nN1=77\nOn1=1\nADR1=200\nSND31=810\n"
                                           "Xo1=-12,5\nYo1=8.25\nTo1=0,4\nInvY1=1\nRotX1=-90\nSetData1=21.01.2017\n"
                                           "AdjData1=24.01.2017\nNote1=Линия 1\nPlace1=Подвал\nProtocol1=2.10\n"
                                           "VerifyCrc1=1\n"
                                           "Name2=x\nName3=x\nName4=x\nName5=x\nName6=x\nName7=x\nName8=x\nName9=x\n"
                                           "Name10=УСМ-ИСН\nN10=70\nSND310=11\nProtocol10=z\nRS485=1\n");
    QCOMPARE(complaintTexts(reading), QStringList());
    SensorConfig expected;
    expected.port = 1;
    expected.index = 1;
    expected.number = 77;
    expected.address = 200;
    expected.isOn = true;
    expected.type = SensorType::InD;
    expected.model = u"IN-D3"_s;
    expected.name = u"ИН-Д3, ось; 1"_s;
    expected.place = u"Подвал"_s;
    expected.serialNumber = u"810"_s;
    expected.installedOn = u"21.01.2017"_s;
    expected.adjustedOn = u"24.01.2017"_s;
    expected.note = u"Линия 1"_s;
    expected.measuresTilt = true;
    expected.offsetX = -12.5;
    expected.offsetY = 8.25;
    expected.offsetT = 0.4;
    expected.isYInverted = true;
    expected.rotationX = -90;
    expected.options = {{u"protocol"_s, u"2.10"_s}, {u"verifycrc"_s, u"1"_s}};
    const QList<SensorConfig> &sensors = reading.config.lines.at(0).sensors;
    QCOMPARE(sensors.size(), 10);
    QVERIFY(sensors.at(0) == expected);
    QCOMPARE(sensors.at(9).serialNumber, u"11"_s);
    QCOMPARE(sensors.at(9).number, 70);
    QCOMPARE(sensors.at(9).options, (QHash<QString, QString>{{u"protocol"_s, u"z"_s}}));
    QCOMPARE(sensors.at(4).options, (QHash<QString, QString>()));
}

void TestServerConfig::takesTheIndexOffAKey_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("index");
    QTest::newRow("N1") << u"N1"_s << u"n"_s << 1;
    QTest::newRow("Name12") << u"Name12"_s << u"name"_s << 12;
    QTest::newRow("Note1") << u"Note1"_s << u"note"_s << 1;
    QTest::newRow("SND31") << u"SND31"_s << u"snd3"_s << 1;
    QTest::newRow("SND310") << u"snd310"_s << u"snd3"_s << 10;
    QTest::newRow("SND33") << u"SND33"_s << u"snd3"_s << 3;
    QTest::newRow("SND3") << u"SND3"_s << QString() << 0;
    QTest::newRow("SND3x1") << u"SND3x1"_s << u"snd3x"_s << 1;
    QTest::newRow("RS485") << u"RS485"_s << QString() << 0;
    QTest::newRow("Num") << u"Num"_s << QString() << 0;
    QTest::newRow("adr01") << u"adr01"_s << QString() << 0;
    QTest::newRow("adr0") << u"adr0"_s << QString() << 0;
    QTest::newRow("12") << u"12"_s << QString() << 0;
    QTest::newRow("adr99999999999") << u"adr99999999999"_s << QString() << 0;
}

void TestServerConfig::takesTheIndexOffAKey()
{
    QFETCH(QString, key);
    QFETCH(QString, name);
    QFETCH(int, index);
    const auto read = sensorKey(key);
    QCOMPARE(read.has_value(), index > 0);
    if (read) {
        QCOMPARE(read->name, name);
        QCOMPARE(read->index, index);
    }
}

void TestServerConfig::setsCapabilitiesByType()
{
    const ConfigReading reading =
        readPort("NumOfSensors=7\nName1=ИН-Д3 (TMP05, ускорение)\nName2=АН-Д3\nName3=АН-Д3, подогрев\nAccelOn3=0\n"
                 "Name4=УСМ-ИСН\nName5=L-VIMS\nName6=МК-14\nName7=Резерв\nOn7=0\n");
    QStringList quantities;
    for (const QString &text : sensorTexts(reading.config)) {
        quantities.append(text.section(u", "_s, 3));
    }
    QCOMPARE(
        quantities,
        (QStringList{
            u"IN-D3, SND3 , tilt"_s, u"AN-D3, SND3 , tilt temperature acceleration"_s,
            u"AN-D3, SND3 , tilt temperature heating"_s, u"USM-ISN, SND3 , tilt temperature"_s, u"L-VIMS, SND3 , "_s,
            u"MK-14, SND3 , temperature"_s, u", SND3 , "_s}));
    QCOMPARE(complaintTexts(reading), QStringList());
}

/// UsmRevive of [Common] is for those УСМ-ИСН that have no key of their own.
void TestServerConfig::aSensorDecidesBeforeTheSite()
{
    const QByteArray port = "NumOfPorts=1\n[Port1]\nOn=1\nNum=3\nNumOfSensors=3\nName1=USM-ISN\nadr1=1\nN1=1\n"
                            "Name2=USM-ISN\nadr2=2\nN2=2\nUsmRevive2=1\nName3=IN-D3\nadr3=3\nN3=3\n";
    const auto options = [](const ConfigReading &reading) {
        QStringList texts;
        for (const SensorConfig &sensor : reading.config.lines.constFirst().sensors) {
            texts += sensor.options.value(u"usmrevive"_s, u"-"_s);
        }
        return texts.join(u' ');
    };
    QCOMPARE(options(read("[Common]\n" + port)), u"- 1 -"_s);
    QCOMPARE(options(read("[Common]\nUsmRevive=1\n" + port)), u"- 1 -"_s);
    const ConfigReading off = read("[Common]\nUsmRevive=0\n" + port);
    QCOMPARE(options(off), u"0 1 -"_s);
    QCOMPARE(complaintTexts(off), QStringList());
    QCOMPARE(complaintTexts(read("[Common]\nUsmRevive=x\n" + port)).size(), 1);
}

void TestServerConfig::clockOfAStationIsThatOfSensorPortOrSite()
{
    const QByteArray site = "[Common]\nNumOfPorts=2\nStationClock=UTC\n[Port1]\nNumOfSensors=2\nName1=МК-14\n"
                            "StationClock1=local\nName2=МК-14\n[Port2]\nStationClock=local\nNumOfSensors=2\n"
                            "Name1=МК-14\nName2=ИН-Д3\n";
    QStringList clocks;
    for (const LineConfig &line : read(site).config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            clocks.append(sensor.options.value(u"stationclock"_s, u"none"_s));
        }
    }
    QCOMPARE(clocks, QStringList({u"local"_s, u"UTC"_s, u"local"_s, u"none"_s}));
}

QTEST_GUILESS_MAIN(TestServerConfig)

#include "tst_serverconfig.moc"
