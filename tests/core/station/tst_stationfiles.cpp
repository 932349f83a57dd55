#include "core/station/stationconfig.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace std::chrono_literals;

namespace {

QStringList texts(const Complaints &complaints)
{
    QStringList texts;
    const QList<StationComplaint> list = complaints.list();
    for (const StationComplaint &complaint : list) {
        texts.append(complaint.text());
    }
    return texts;
}

void row(const char *name, const char *line, const char *complaint)
{
    QTest::newRow(name) << QByteArray(line) << QString::fromUtf8(complaint);
}

const char *const goodLine = "\"Атм. давление\" мм.рт.ст - P 1 A 300 %5.1f 600 800 2.5 /0.5/ 10 20 0.3\n";

} // namespace

/// ACK.INI, ACK.PAR and ACK.PSE: what good lines say, and what is said of others.
class TestStationFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void objects()
    {
        Complaints complaints;
        const QList<StationObject> objects = readObjects(
            QStringLiteral("ACK.INI"),
            "; objects of the station\n"
            "5 60 x\n"
            "5 0 W - - - - -\n"
            "5 0 a:file:record.csv\n"
            "5 0 v1 9600 8 1 0 250\n"
            "5 0 q2 19200 7 2 2 -\n"
            "9 600 Q:tcp://10.0.0.9:4001\n"
            "5 - q3 4800 8 1.5 7 \"two words\"\n",
            complaints);
        QCOMPARE(texts(complaints), QStringList());
        QCOMPARE(objects.size(), 7);
        QCOMPARE(objects[0].kind, ObjectKind::Gathering);
        QCOMPARE(objects[0].number, 5);
        QCOMPARE(objects[0].period, 60s);
        QCOMPARE(objects[0].line, 2);
        QCOMPARE(objects[1].kind, ObjectKind::L154);
        QCOMPARE(objects[2].kind, ObjectKind::Fastwel);
        QCOMPARE(objects[2].device, QStringLiteral("file:record.csv"));
        QCOMPARE(objects[3].kind, ObjectKind::Wind);
        QCOMPARE(objects[3].com, 1);
        QCOMPARE(objects[3].windMultiplier, 250);
        QCOMPARE(objects[4].kind, ObjectKind::Line);
        QCOMPARE(objects[4].com, 2);
        QCOMPARE(objects[4].baudRate, 19200);
        QCOMPARE(objects[4].dataBits, 7);
        QCOMPARE(objects[4].stopBits, StopBits::Two);
        QCOMPARE(objects[4].parity, Parity::Even);
        QVERIFY(objects[4].isDispatcher(5));
        QVERIFY(!objects[4].isPolled(5));
        QVERIFY(objects[5].isPolled(5));
        QCOMPARE(objects[5].device, QStringLiteral("tcp://10.0.0.9:4001"));
        QCOMPARE(objects[5].baudRate, 9600);
        QCOMPARE(objects[6].stopBits, StopBits::OneAndHalf);
        QCOMPARE(objects[6].parity, Parity::Space);
        QCOMPARE(objects[6].extra, QStringLiteral("two words"));
    }

    void faultyObjects_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("complaint");
        row("number", "0 60 x", "field 1 (number): “0” is not between 1 and 255.");
        row("half a number", "1.5 60 x", "field 1 (number): “1.5” is not a whole number.");
        row("period", "1 often x", "field 2 (period): “often” is not a number.");
        row("no port", "1 60", "field 3 (port): The field is missing.");
        row("dash for a port", "1 60 -",
            "field 3 (port): “” is no port: it begins with one of the letters x, w, a, v, q.");
        row("type", "1 60 k1", "field 3 (port): “k1” is no port: it begins with one of the letters x, w, a, v, q.");
        row("telegrams", "1 60 r1 9600 8 1 0 -",
            "field 3 (port): A port of the type “r” cannot be used: no document says how its data look. Measure with "
            "another source.");
        row("thermometer", "1 60 Y2 9600 8 1 0 -",
            "field 3 (port): A port of the type “Y” cannot be used: no document says how its data look. Measure with "
            "another source.");
        row("fields of the earth", "1 60 g2 9600 8 1 0 -",
            "field 3 (port): A port of the type “g” cannot be used: no document says how its data look. Measure with "
            "another source.");
        row("no number of a port", "1 60 q 9600 8 1 0 -",
            "field 3 (port): The type letter has no port behind it: write its number, as in q1.");
        row("wrong number of a port", "1 60 qx 9600 8 1 0 -",
            "field 3 (port): “x” is not the number of a port, 1 to 256.");
        row("empty device", "1 60 q: 9600 8 1 0 -",
            "field 3 (port): The type letter has no port behind it: write its number, as in q1.");
        row("speed", "1 60 q1 fast 8 1 0 -", "field 4 (speed): “fast” is not a number.");
        row("no speed", "1 60 q1", "field 4 (speed): The field is missing.");
        row("data bits", "1 60 q1 9600 9 1 0 -", "field 5 (data bits): “9” is not between 5 and 8.");
        row("stop bits", "1 60 q1 9600 8 1.2 0 -", "field 6 (stop bits): There are 1, 1.5 or 2 stop bits.");
        row("parity", "1 60 q1 9600 8 1 3 -",
            "field 7 (parity): The parity is 0 (none), 1 (odd), 2 (even), 5 (mark) or 7 (space).");
        row("multiplier", "1 60 v1 9600 8 1 0 1001", "field 8 (extra): “1001” is not between 1 and 1000.");
        row("port twice", "1 60 q7 9600 8 1 0 -", "field 3 (port): COM7 is used in line 1.");
        row("open quote", "1 60 q1 9600 8 1 0 \"abc", "field 8: The text has no closing double quote.");
    }

    void faultyObjects()
    {
        QFETCH(const QByteArray, line);
        QFETCH(const QString, complaint);
        Complaints complaints;
        const QList<StationObject> objects =
            readObjects(QStringLiteral("ACK.INI"), "1 60 v7 - - - - -\n" + line, complaints);
        QCOMPARE(
            texts(complaints),
            QStringList{QStringLiteral("ACK.INI, line 2, ") + complaint + QStringLiteral(" The object is left out.")});
        QCOMPARE(objects.size(), 1);
    }

    void parameters()
    {
        Complaints complaints;
        const QList<ParameterConfig> parameters = readParameters(
            QStringLiteral("ACK.PAR"),
            goodLine + QByteArray("- °C Тнар Т 12 А - - - - - 1\n- м/с - М 1 A 0 %6f 0 60 0,5 0 1"), complaints);
        QCOMPARE(texts(complaints), QStringList());
        QCOMPARE(parameters.size(), 3);
        ParameterConfig pressure;
        pressure.name = QStringLiteral("Атм. давление");
        pressure.unit = QStringLiteral("мм.рт.ст");
        pressure.code = u'P';
        pressure.averaging = 300s;
        pressure.format = {5, 1};
        pressure.limits = {600, 800};
        pressure.error = 2.5;
        pressure.conversion = {0.5, {10, 20, 0.3}};
        pressure.line = 1;
        QCOMPARE(parameters[0], pressure);
        ParameterConfig temperature;
        temperature.unit = QStringLiteral("°C");
        temperature.shortName = QStringLiteral("Тнар");
        temperature.code = u'T'; // Cyrillic in the file
        temperature.number = 12;
        temperature.conversion = {0, {1}};
        temperature.line = 2;
        QCOMPARE(parameters[1], temperature);
        QVERIFY(parameters[1].conversion.isThreshold());
        QCOMPARE(parameters[2].code, QChar(u'M'));
        QCOMPARE(parameters[2].error, 0.5);
        QCOMPARE(parameters[2].format, (OutputFormat{6, 6}));
    }

    void format()
    {
        QCOMPARE((OutputFormat{7, 2}).text(-3.14159), QStringLiteral("  -3.14"));
        QCOMPARE((OutputFormat{2, 0}).text(1234.6), QStringLiteral("1235"));
    }

    void faultyParameters_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("complaint");
        row("code", "- C - 7 1 A 0 - - - - 0 1", "field 4 (code): “7” is not one Latin letter.");
        row("Russian code", "- C - Ж 1 A 0 - - - - 0 1", "field 4 (code): “Ж” is not one Latin letter.");
        row("number", "- C - T 100 A 0 - - - - 0 1", "field 5 (number): “100” is not between 1 and 99.");
        row("type", "- C - T 1 AB 0 - - - - 0 1", "field 6 (type): “AB” is not one Latin letter.");
        row("averaging", "- C - T 1 A x - - - - 0 1", "field 7 (averaging): “x” is not a number.");
        row("averaging for ever", "- C - T 1 A 86401 - - - - 0 1",
            "field 7 (averaging): “86401” is not between 0 and 86400.");
        row("format", "- C - T 1 A 0 5.1 - - - 0 1", "field 8 (format): “5.1” is no format: write it as in %5.1f.");
        row("left", "- C - T 1 A 0 - abc - - 0 1", "field 9 (left limit): “abc” is not a number.");
        row("right", "- C - T 1 A 0 - 0 1..2 - 0 1", "field 10 (right limit): “1..2” is not a number.");
        row("limits the wrong way", "- C - T 1 A 0 - 5 4 - 0 1",
            "field 10 (right limit): The right limit is less than the left one.");
        row("error", "- C - T 1 A 0 - 0 1 -1 0 1", "field 11 (error): “-1” is not between 0 and 1e+30.");
        row("x0", "- C - T 1 A 0 - 0 1 1 /a/ 0 1", "field 12 (x0): “a” is not a number.");
        row("coefficient", "- C - T 1 A 0 - 0 1 1 /2/ 0 b", "field 14 (polynomial): “b” is not a number.");
        row("no coefficients", "- C - T 1 A 0 - 0 1 1", "field 12 (polynomial): The polynomial has no coefficients.");
        row("only x0", "- C - T 1 A 0 - 0 1 1 /2", "field 13 (polynomial): The polynomial has no coefficients.");
        row("eleven coefficients", "- C - T 1 A 0 - 0 1 1 0 1 2 3 4 5 6 7 8 9 10",
            "field 22 (polynomial): A polynomial has at most 10 coefficients.");
        row("short", "- C - T 1", "field 6 (type): The field is missing.");
        row("twice", "- C - P 1 A 0 - 0 1 1 0 1", "field 4 (code): The parameter P 1 stands in line 1 already.");
        row("open quote", "\"T C - T 1", "field 1: The text has no closing double quote.");
    }

    void faultyParameters()
    {
        QFETCH(const QByteArray, line);
        QFETCH(const QString, complaint);
        Complaints complaints;
        const QList<ParameterConfig> parameters =
            readParameters(QStringLiteral("ACK.PAR"), goodLine + line, complaints);
        QCOMPARE(
            texts(complaints),
            QStringList{
                QStringLiteral("ACK.PAR, line 2, ") + complaint + QStringLiteral(" The parameter is left out.")});
        QCOMPARE(parameters.size(), 1);
    }

    void settings()
    {
        QByteArray bytes;
        for (const char *value :
             {"17 number",
              "0 sigma",
              "1",
              "2",
              "3",
              "4",
              "5",
              "6",
              "7",
              "8",
              "9",
              "10",
              "182 ticks",
              "14",
              "15",
              "16",
              "17",
              "18",
              "19",
              "20",
              "-5 shift",
              "1 SAFE",
              "4 attempts",
              "9 ticks",
              "25",
              "60 calibration",
              "27",
              "300 averaging",
              "66.6 percent",
              "1 no protocol",
              "120 watchdog",
              "1 test",
              "50 filter"}) {
            bytes += QByteArray(value) + "\r\n";
        }
        Complaints complaints;
        const StationSettings settings = readSettings(QStringLiteral("ACK.PSE"), "; head\r\n" + bytes, complaints);
        QCOMPARE(
            texts(complaints),
            QStringList{QStringLiteral(
                "ACK.PSE: The values 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 17, 18, 19, 20, 25, 27 are without "
                "effect here.")});
        const StationSettings expected{17, false, 182, -5s, true, 4, 9, 60s, 300s, 66.6, true, 120s, true, 50us};
        QCOMPARE(settings, expected);
        QCOMPARE(ticks(182), 10s);
        QCOMPARE(ticks(1), 54945us);
    }

    void faultySettings()
    {
        Complaints complaints;
        const StationSettings settings = readSettings(QStringLiteral("ACK.PSE"), "256\nyes\n;\n- \"open\n", complaints);
        QCOMPARE(
            texts(complaints),
            QStringList({
                QStringLiteral("ACK.PSE, line 1, field 1 (number of the station): “256” is not between 1 and 255. 1 is "
                               "used."),
                QStringLiteral("ACK.PSE, line 2, field 1 (calculation of σ): “yes” is not a number. 1 is used."),
                QStringLiteral("ACK.PSE: The file has 3 of 33 values. The usual ones are used for the others."),
                QStringLiteral("ACK.PSE: The values 3 are without effect here."),
            }));
        QCOMPARE(settings, StationSettings());
    }

    /// A mean that needs more than all values would never come.
    void everyValueGoodIsTooMuch()
    {
        Complaints complaints;
        QByteArray bytes = QByteArray("1\n").repeated(28) + "100\n1\n1\n1\n1\n";
        const StationSettings settings = readSettings(QStringLiteral("ACK.PSE"), bytes, complaints);
        QCOMPARE(settings.goodPercent, 50.0);
        QCOMPARE(
            texts(complaints).first(),
            QStringLiteral("ACK.PSE, line 29, field 1 (percent of good values): “100” is not between 0 and 99.9. 50 is "
                           "used."));
    }

    void rubbishIsNotToldForEver()
    {
        Complaints complaints;
        readParameters(QStringLiteral("ACK.PAR"), QByteArray("x\n").repeated(5000), complaints);
        QCOMPARE(complaints.list().size(), 201);
        QCOMPARE(complaints.list().last().text(), QStringLiteral("ACK.PAR: … and 4800 more."));
    }
};

QTEST_GUILESS_MAIN(TestStationFiles)
#include "tst_stationfiles.moc"
