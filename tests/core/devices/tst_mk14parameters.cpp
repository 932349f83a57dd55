#include "core/devices/mk14/mk14options.h"
#include "tests/core/devices/mk14station.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::mk14;
using namespace gorizont::test;

namespace {

QString text(const QList<ParameterName> &parameters)
{
    QStringList parts;
    for (const ParameterName &parameter : parameters) {
        parts.append(
            QStringLiteral("%1%2|%3|%4").arg(parameter.code).arg(parameter.number).arg(parameter.name, parameter.unit));
    }
    return parts.join(u' ');
}

QString codes(const QList<ParameterName> &parameters)
{
    QStringList parts;
    for (const ParameterName &parameter : parameters) {
        parts.append(QString(parameter.code) + QString::number(parameter.number));
    }
    return parts.join(u' ');
}

// One file in three encodings, packed by Python: str.encode(); its text:
//     ; параметры станции
//     "Напряжение питания" В - U 1 A 0 %5.1f 0 20 1 0 1
//     "Ёмкость воздуха" °C Т T 02 A 600 %6.2f -60 60 2 /1/ 0 1 ; термометр
//
//     - "м/с" "V ветра" M 1 A 0 %5.1f 0 60 0.5 0 1
//     мало полей здесь
//     имя В - UU 1 A
//     имя В - U один A
const QByteArray utf8 = QByteArray::fromHex(
    "3b20d0bfd0b0d180d0b0d0bcd0b5d182d180d18b20d181d182d0b0d0bdd186d0b8d0b80d0a22d09dd0b0d0bfd180d18f"
    "d0b6d0b5d0bdd0b8d0b520d0bfd0b8d182d0b0d0bdd0b8d18f2220d092202d20552031204120302025352e3166203020"
    "32302031203020310d0a22d081d0bcd0bad0bed181d182d18c20d0b2d0bed0b7d0b4d183d185d0b02220c2b04320d0a2"
    "20542030322041203630302025362e3266202d36302036302032202f312f20302031203b20d182d0b5d180d0bcd0bed0"
    "bcd0b5d182d1800d0a0d0a2d2022d0bc2fd1812220225620d0b2d0b5d182d180d0b022204d2031204120302025352e31"
    "66203020363020302e35203020310d0ad0bcd0b0d0bbd0be20d0bfd0bed0bbd0b5d0b920d0b7d0b4d0b5d181d18c0d0a"
    "d0b8d0bcd18f20d092202d205555203120410d0ad0b8d0bcd18f20d092202d205520d0bed0b4d0b8d0bd20410d0a");
const QByteArray windows1251 = QByteArray::fromHex(
    "3b20efe0f0e0ece5f2f0fb20f1f2e0edf6e8e80d0a22cde0eff0ffe6e5ede8e520efe8f2e0ede8ff2220c2202d205520"
    "31204120302025352e316620302032302031203020310d0a22a8eceaeef1f2fc20e2eee7e4f3f5e02220b04320d22054"
    "2030322041203630302025362e3266202d36302036302032202f312f20302031203b20f2e5f0eceeece5f2f00d0a0d0a"
    "2d2022ec2ff12220225620e2e5f2f0e022204d2031204120302025352e3166203020363020302e35203020310d0aece0"
    "ebee20efeeebe5e920e7e4e5f1fc0d0ae8ecff20c2202d205555203120410d0ae8ecff20c2202d205520eee4e8ed2041"
    "0d0a");
const QByteArray cp866 = QByteArray::fromHex(
    "3b20afa0e0a0aca5e2e0eb20e1e2a0ade6a8a80d0a228da0afe0efa6a5ada8a520afa8e2a0ada8ef222082202d205520"
    "31204120302025352e316620302032302031203020310d0a22f0acaaaee1e2ec20a2aea7a4e3e5a02220f84320922054"
    "2030322041203630302025362e3266202d36302036302032202f312f20302031203b20e2a5e0acaeaca5e2e00d0a0d0a"
    "2d2022ac2fe12220225620a2a5e2e0a022204d2031204120302025352e3166203020363020302e35203020310d0aaca0"
    "abae20afaeaba5a920a7a4a5e1ec0d0aa8acef2082202d205555203120410d0aa8acef2082202d205520aea4a8ad2041"
    "0d0a");

SensorConfig with(const QString &key, const QString &value)
{
    SensorConfig sensor = weatherStation();
    sensor.index = 3;
    sensor.options.insert(key, value);
    return sensor;
}

} // namespace

/// Which parameters a station has, and the other keys of a station.
class TstMk14Parameters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lists_data()
    {
        QTest::addColumn<QString>("list");
        QTest::addColumn<QString>("expected");
        QTest::newRow("usual") << "U,T,P,H,A,M"
                               << "U1 T1 P1 H1 A1 M1";
        QTest::newRow("repeated") << "T,T,t,T"
                                  << "T1 T2 t1 T3";
        QTest::newRow("numbered") << " M2 ; A2, T10 T"
                                  << "M2 A2 T10 T11";
        QTest::newRow("Cyrillic letters that look alike") << "Т,Р,Н,А,М"
                                                          << "T1 P1 H1 A1 M1";
        QTest::newRow("empty") << " , "
                               << "";
        QTest::newRow("a digit") << "U,7"
                                 << "";
        QTest::newRow("a word") << "U,Temp"
                                << "";
        QTest::newRow("number 0") << "T0"
                                  << "";
    }

    void lists()
    {
        QFETCH(const QString, list);
        QFETCH(const QString, expected);
        QCOMPARE(codes(parametersInList(list).value_or(QList<ParameterName>())), expected);
    }

    void namesOfTheUsualOnes()
    {
        QCOMPARE(
            text(usualParameters()),
            QStringLiteral("U1|Supply voltage|V T1|Temperature|°C P1|Pressure|mm Hg H1|Humidity|% A1|Wind direction|° "
                           "M1|Wind speed|m/s"));
    }

    void fileInThreeEncodings_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("UTF-8") << utf8;
        QTest::newRow("UTF-8 with a mark") << "\xEF\xBB\xBF" + utf8;
        QTest::newRow("Windows-1251") << windows1251;
        QTest::newRow("CP866") << cp866;
    }

    void fileInThreeEncodings()
    {
        QFETCH(const QByteArray, bytes);
        const ParameterFile file = parametersInFile(bytes);
        QCOMPARE(text(file.parameters), QStringLiteral("U1|Напряжение питания|В T2|Ёмкость воздуха|°C M1||м/с"));
        QCOMPARE(file.badLines, QList<int>({6, 7, 8}));
    }

    void optionsOfAStation()
    {
        const Options usual = Options::from(weatherStation());
        QCOMPARE(usual.commands, QList<int>({8, 4}));
        QCOMPARE(usual.outputs, 0U);
        QVERIFY(!usual.isClockUtc && usual.complaints.isEmpty());
        QCOMPARE(Options::from(with(QStringLiteral("cmd"), QStringLiteral("1"))).commands, QList<int>({1}));
        QCOMPARE(Options::from(with(QStringLiteral("cmd"), QStringLiteral("6 8"))).commands, QList<int>({6, 8}));
        QCOMPARE(Options::from(with(QStringLiteral("outputs"), QStringLiteral("0xFFFFFFFF"))).outputs, 0xFFFFFFFFU);
        QCOMPARE(Options::from(with(QStringLiteral("outputs"), QStringLiteral("12"))).outputs, 12U);
        QVERIFY(Options::from(with(QStringLiteral("stationclock"), QStringLiteral("utc"))).isClockUtc);
    }

    void whatIsNotUnderstoodIsToldAndTheUsualUsed_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("complaint");
        QTest::newRow("cmd") << "cmd"
                             << "8,9"
                             << "Cmd3 is \"8,9\", but takes numbers from 1 to 8, like 8,4.";
        QTest::newRow("outputs") << "outputs"
                                 << "0x100000000"
                                 << "Outputs3 is \"0x100000000\"";
        QTest::newRow("clock") << "stationclock"
                               << "MSK"
                               << "StationClock3 is \"MSK\", but takes UTC, local.";
        QTest::newRow("params") << "params"
                                << "U,,1"
                                << "Params3 is \"U,,1\"";
        QTest::newRow("file") << "parfile"
                              << "/nowhere/ACK.PAR"
                              << "ParFile3: /nowhere/ACK.PAR: ";
    }

    void whatIsNotUnderstoodIsToldAndTheUsualUsed()
    {
        QFETCH(const QString, key);
        QFETCH(const QString, value);
        QFETCH(const QString, complaint);
        Options options = Options::from(with(key, value));
        QCOMPARE(options.complaints.size(), 1);
        QVERIFY2(options.complaints.first().startsWith(complaint), qPrintable(options.complaints.first()));
        options.complaints.clear();
        QVERIFY(options.commands == QList<int>({8, 4}) && options.outputs == 0 && !options.isClockUtc);
        QVERIFY(options.parameters == usualParameters());
    }

    void theFileComesBeforeTheList()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("ACK.PAR"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("wrong\nx - - Q 4 A 0 %5.1f 0 1 1 0 1\n");
        file.close();
        SensorConfig sensor = with(QStringLiteral("parfile"), path);
        sensor.options.insert(QStringLiteral("params"), QStringLiteral("M,A"));
        const Options options = Options::from(sensor);
        QCOMPARE(text(options.parameters), QStringLiteral("Q4|x|"));
        QCOMPARE(options.complaints.size(), 1);
        QVERIFY(options.complaints.first().contains(QStringLiteral("ACK.PAR, line 1: ")));
    }
};

QTEST_GUILESS_MAIN(TstMk14Parameters)
#include "tst_mk14parameters.moc"
