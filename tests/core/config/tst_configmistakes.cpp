#include "tests/core/config/configreading.h"

#include <QTest>

#include <ctime>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

class TestConfigMistakes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void complainsOfEveryMistake();
    void goesOnAfterEveryMistake();
    void numbersAreTooSmallOrTooLarge();
    void textsHaveAnEnd();
    void keepsWhatWasReplaced();
    void sensorsThatAreOffTakeNothing();
    void absentNumbersGoRoundGivenOnes();
    void samePortMayBeWrittenInManyWays_data();
    void samePortMayBeWrittenInManyWays();
    void adc24TakesAnAccelerometer_data();
    void adc24TakesAnAccelerometer();
    void twoServersCannotHaveOnePort();
    void emptyFileGivesOneComplaint();
    void binaryFileGivesReadableComplaints();
    void hugeFileGivesABoundedListOfComplaints();
    void demoHasNoMistakes();
};

void TestConfigMistakes::complainsOfEveryMistake()
{
    const QStringList expected =
        QString::fromUtf8(dataFile(u"mistakes.expected.txt"_s)).split(u'\n', Qt::SkipEmptyParts);
    const QStringList actual = complaintTexts(read(dataFile(u"mistakes.ini"_s)));
    for (qsizetype i = 0; i < qMin(expected.size(), actual.size()); ++i) {
        QCOMPARE(actual.at(i), expected.at(i));
    }
    QCOMPARE(actual.size(), expected.size());
}

void TestConfigMistakes::goesOnAfterEveryMistake()
{
    const ServerConfig config = read(dataFile(u"mistakes.ini"_s)).config;
    QStringList lines;
    for (const LineConfig &line : config.lines) {
        lines.append(u"%1 %2"_s.arg(line.index).arg(line.isOn));
    }
    QCOMPARE(lines, (QStringList{u"1 1"_s, u"2 0"_s, u"3 0"_s, u"4 0"_s, u"5 0"_s, u"6 0"_s, u"7 1"_s, u"8 1"_s}));
    QStringList sensors;
    for (const QString &text : sensorTexts(config)) {
        sensors.append(text.section(u", "_s, 0, 2));
    }
    QCOMPARE(
        sensors,
        (QStringList{
            u"port 1 sensor 1: N 1, adr 1, on"_s, u"port 1 sensor 2: N 2, adr 1, off"_s,
            u"port 1 sensor 3: N 3, adr 1, off"_s, u"port 1 sensor 4: N 22, adr 4, off"_s,
            u"port 1 sensor 5: N 5, adr 1, off"_s, u"port 1 sensor 6: N 6, adr 6, off"_s,
            u"port 1 sensor 7: N 7, adr 7, on"_s, u"port 2 sensor 1: N 21, adr 1, on"_s,
            u"port 8 sensor 1: N 23, adr 1, off"_s}));
    QVERIFY(!config.allowsCopy);
    QVERIFY(config.startsHidden);
    QCOMPARE(config.timing.crcErrorPause, 600ms);
    QCOMPARE(config.lines.at(0).com, 4);
}

void TestConfigMistakes::numbersAreTooSmallOrTooLarge()
{
    const ConfigReading reading = read("[Common]\n[Timers]\nTmRun=2147483648\nTmSave=0\n[Errors]\nNumRErrSrs=-1\n");
    QCOMPARE(
        complaintTexts(reading),
        (QStringList{
            u"[Timers] TmRun, line 3: “2147483648” is more than 2147483647. The default 1000 is used."_s,
            u"[Timers] TmSave, line 4: “0” is less than 1. The default 1000 is used."_s,
            u"[Errors] NumRErrSrs, line 6: “-1” is less than 1. The default 10 is used."_s}));
    QVERIFY(reading.config.timing == Timing());
}

void TestConfigMistakes::textsHaveAnEnd()
{
    const ConfigReading good = read("[Common]\nCaption=" + QByteArray(4000, 'x'));
    QCOMPARE(complaintTexts(good), QStringList());
    QCOMPARE(good.config.caption.size(), 4000);
    const ConfigReading endless = read("[Common]\nName=" + QByteArray(1'000'000, 'x'));
    QCOMPARE(
        complaintTexts(endless),
        QStringList{u"[Common] Name, line 2: The text is longer than 4000 characters. Its beginning is used."_s});
    QCOMPARE(endless.config.name.size(), 4000);
}

void TestConfigMistakes::keepsWhatWasReplaced()
{
    const QHash<QString, QString> replaced = read(dataFile(u"mistakes.ini"_s)).config.replaced;
    QCOMPARE(replaced.value(u"common/ipport2"_s), u"70000"_s);
    QCOMPARE(replaced.value(u"common/cancopy"_s), u"1"_s);
    QCOMPARE(replaced.value(u"common/numofports"_s), u"20"_s);
    QCOMPARE(replaced.value(u"port1/adr5"_s), u"256"_s);
    QCOMPARE(replaced.value(u"port1/on2"_s), u"1"_s);
    QCOMPARE(replaced.value(u"port1/n4"_s), u"1"_s);
    QCOMPARE(replaced.value(u"port2/on"_s), u"1"_s);
    QVERIFY(!replaced.contains(u"port1/on1"_s));
}

void TestConfigMistakes::sensorsThatAreOffTakeNothing()
{
    // An old sensor was replaced by a new one with its address and number; the old entry stays, switched off.
    const ConfigReading reading =
        readPort("NumOfSensors=2\nName1=ИН-Д3\nN1=5\nadr1=9\nOn1=0\nName2=ИН-Д3\nN2=5\nadr2=9\n"
                 "On2=1\n");
    QCOMPARE(
        sensorTexts(reading.config),
        (QStringList{
            u"port 1 sensor 1: N 6, adr 9, off, IN-D3, SND3 , tilt"_s,
            u"port 1 sensor 2: N 5, adr 9, on, IN-D3, SND3 , tilt"_s}));
    QCOMPARE(
        complaintTexts(reading),
        QStringList{
            u"[Port1] N1, line 8: Number 5 belongs to sensor 2 of [Port1]. The sensor is listed as number 6."_s});
}

void TestConfigMistakes::absentNumbersGoRoundGivenOnes()
{
    const ConfigReading reading =
        readPort("NumOfSensors=3\nName1=ИН-Д3\nadr1=1\nName2=ИН-Д3\nadr2=2\nName3=ИН-Д3\nadr3=3\n"
                 "N3=2\nOn3=1\n");
    QList<int> numbers;
    for (const SensorConfig &sensor : reading.config.lines.at(0).sensors) {
        numbers.append(sensor.number);
    }
    QCOMPARE(numbers, (QList<int>{1, 4, 2}));
    QCOMPARE(
        complaintTexts(reading),
        QStringList{u"[Port1], line 3: Number 2 belongs to sensor 3 of [Port1]. The sensor is listed as number 4."_s});
}

void TestConfigMistakes::samePortMayBeWrittenInManyWays_data()
{
    QTest::addColumn<QByteArray>("first");
    QTest::addColumn<QByteArray>("second");
    QTest::addColumn<bool>("isSame");
    QTest::newRow("numbers") << QByteArray("Num=4") << QByteArray("Num=4") << true;
    QTest::newRow("default number") << QByteArray("Num=1") << QByteArray("") << true;
    QTest::newRow("other numbers") << QByteArray("Num=4") << QByteArray("Num=5") << false;
    QTest::newRow("COMn") << QByteArray("Num=4") << QByteArray("Device=com4") << true;
    QTest::newRow("ttySn") << QByteArray("Num=4") << QByteArray("Device=/dev/ttyS3") << true;
    QTest::newRow("device wins") << QByteArray("Num=4") << QByteArray("Num=4\nDevice=/dev/ttyUSB0") << false;
    QTest::newRow("paths have case") << QByteArray("Device=/dev/a") << QByteArray("Device=/dev/A") << false;
    QTest::newRow("TCP") << QByteArray("Device=tcp://a:1") << QByteArray("Device=TCP://A:1") << true;
    QTest::newRow("TCP ports") << QByteArray("Device=tcp://a:1") << QByteArray("Device=tcp://a:2") << false;
    QTest::newRow("simulated") << QByteArray("Device=sim:") << QByteArray("Device=sim:") << false;
    QTest::newRow("first is off") << QByteArray("Num=4\nOn=0") << QByteArray("Num=4") << false;
}

void TestConfigMistakes::samePortMayBeWrittenInManyWays()
{
    QFETCH(QByteArray, first);
    QFETCH(QByteArray, second);
    QFETCH(bool, isSame);
    const ConfigReading reading =
        read("[Common]\nNumOfPorts=2\n[Port1]\n" + first + "\nOn=1\n[Port2]\n" + second + "\nOn=1\n");
    QCOMPARE(reading.config.lines.at(1).isOn, !isSame);
}

void TestConfigMistakes::adc24TakesAnAccelerometer_data()
{
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<int>("sensor");
    QTest::addColumn<Adc24Axis>("axis");
    QTest::addColumn<QString>("complaint");
    QTest::newRow("absent") << QByteArray("") << 0 << Adc24Axis::X << QString();
    QTest::newRow("good") << QByteArray("Sensor=8\nAxis=Y\n") << 8 << Adc24Axis::Y << QString();
    QTest::newRow("Cyrillic X") << QByteArray("Axis=Х\n") << 0 << Adc24Axis::X << QString();
    QTest::newRow("Cyrillic Y") << QByteArray("Axis=у\n") << 0 << Adc24Axis::Y << QString();
    QTest::newRow("no such sensor") << QByteArray("Sensor=9\n") << 0 << Adc24Axis::X
                                    << u"[ADC24] Sensor, line 10: The site has no accelerometer with number 9. "
                                       "The first accelerometer is used."_s;
    QTest::newRow("an inclinometer") << QByteArray("Sensor=7\n") << 0 << Adc24Axis::X
                                     << u"[ADC24] Sensor, line 10: The site has no accelerometer with number 7. "
                                        "The first accelerometer is used."_s;
    QTest::newRow("no number") << QByteArray("Sensor=first\n") << 0 << Adc24Axis::X
                               << u"[ADC24] Sensor, line 10: “first” is not a whole number. "
                                  "The first accelerometer is used."_s;
    QTest::newRow("number 0") << QByteArray("Sensor=0\n") << 0 << Adc24Axis::X
                              << u"[ADC24] Sensor, line 10: “0” is less than 1. The first accelerometer is used."_s;
    QTest::newRow("no axis") << QByteArray("Axis=Z\n") << 0 << Adc24Axis::X
                             << u"[ADC24] Axis, line 10: “Z” is none of X, Y. The default X is used."_s;
}

void TestConfigMistakes::adc24TakesAnAccelerometer()
{
    QFETCH(const QByteArray, keys);
    QFETCH(const QString, complaint);
    const ConfigReading reading =
        read("[Common]\nNumOfPorts=1\n[Port1]\nNumOfSensors=2\nName1=ИН-Д3\nN1=7\nName2=АН-Д3\nN2=8\n[ADC24]\n" + keys);
    QTEST(reading.config.adc24Sensor, "sensor");
    QTEST(reading.config.adc24Axis, "axis");
    QCOMPARE(complaintTexts(reading).join(u'|'), complaint);
    QCOMPARE(reading.config.replaced.size(), complaint.isEmpty() ? 0 : 1);
}

void TestConfigMistakes::twoServersCannotHaveOnePort()
{
    const ConfigReading reading = read("[Common]\nIPPort1=5020\nIPPort2=5020\n");
    QCOMPARE(
        complaintTexts(reading),
        QStringList{u"[Common] IPPort2, line 3: 5020 is the port of Modbus TCP already. ADC24 TCP is switched off."_s});
    QVERIFY(!reading.config.servesAdc24);
    QVERIFY(reading.config.servesModbus);
    QVERIFY(read("[Common]\nIPPort1=5020\nIPPort2=5020\nCanADC24=0\n").complaints.isEmpty());
    QVERIFY(read("[Common]\nIPPort1=5020\nIPPort2=5020\nCanModbus=0\n").config.servesAdc24);
}

void TestConfigMistakes::emptyFileGivesOneComplaint()
{
    const QStringList expected{
        u"The file has no sections. The defaults of all settings are used, nothing is polled."_s};
    QCOMPARE(complaintTexts(readServerConfig(IniFile())), expected);
    QCOMPARE(complaintTexts(read(dataFile(u"empty.ini"_s))), expected);
    QCOMPARE(
        complaintTexts(read("[Timers]\nTmRun=5\n")),
        QStringList{u"There is no section [Common]. The defaults of all its settings are used."_s});
    QVERIFY(readServerConfig(IniFile()).config == ServerConfig());
}

void TestConfigMistakes::binaryFileGivesReadableComplaints()
{
    const ConfigReading reading = read(dataFile(u"binary.ini"_s));
    QVERIFY(!reading.complaints.isEmpty());
    QVERIFY(reading.config == ServerConfig());
    const ConfigReading noise = read("[Common]\nIPPort1=\x01\x02\xFF" + QByteArray(1000, 'x') + "\n");
    const QStringList texts = complaintTexts(noise) + complaintTexts(reading);
    for (const QString &text : texts) {
        QVERIFY2(text.size() < 300, qPrintable(text));
        QVERIFY2(std::all_of(text.begin(), text.end(), [](QChar c) { return c.isPrint(); }), qPrintable(text));
    }
}

void TestConfigMistakes::hugeFileGivesABoundedListOfComplaints()
{
    QByteArray bytes("[Common]\nNumOfPorts=1\n[Port1]\nOn=1\nNumOfSensors=2000000000\n");
    int sensors = 0;
    while (bytes.size() < 10'000'000) {
        const QByteArray index = QByteArray::number(++sensors);
        bytes += "Name" + index + "=IN-D3\nadr" + index + "=1\nOn" + index + "=1\nN" + index + "=1\nN" + index + "=1\n";
    }
    const std::clock_t start = std::clock();
    const ConfigReading reading = read(bytes);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    qInfo() << seconds << "s for" << sensors << "sensors";
    QVERIFY2(seconds < 60, "something is quadratic");
    QCOMPARE(reading.config.lines.at(0).sensors.size(), 255);
    QCOMPARE(reading.complaints.size(), 201);
    // NumOfSensors is too large and those beyond are ignored; 254 numbers are taken; every N stands twice.
    QCOMPARE(reading.complaints.last().text(), u"… and %1 more."_s.arg(2 + 254 + sensors - 200));
}

void TestConfigMistakes::demoHasNoMistakes()
{
    const ConfigReading reading = read(readAll(QStringLiteral(GORIZONT_TEST_DATA "/../../resources/demo.ini")));
    QCOMPARE(complaintTexts(reading), QStringList());
    QCOMPARE(reading.config.lines.size(), 2);
    QCOMPARE(reading.config.lines.at(0).device, u"sim:"_s);
    QCOMPARE(reading.config.lines.at(0).sensors.size(), 6);
    QCOMPARE(reading.config.lines.at(1).sensors.size(), 4);
    QVERIFY(reading.config.lines.at(1).sensors.last().hasThermostat);
    QVERIFY(reading.config.modbusPort > 1023 && reading.config.adc24Port > 1023);
    for (const LineConfig &line : reading.config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            QVERIFY(line.isOn && sensor.isOn && !sensor.place.isEmpty());
        }
    }
}

QTEST_GUILESS_MAIN(TestConfigMistakes)

#include "tst_configmistakes.moc"
