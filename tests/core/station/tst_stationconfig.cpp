#include "core/station/stationfolder.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont::station;
using namespace std::chrono_literals;

namespace {

QStringList texts(const QList<StationComplaint> &list)
{
    QStringList texts;
    for (const StationComplaint &complaint : list) {
        texts.append(complaint.text());
    }
    return texts;
}

QList<BoardInput> inputs(std::initializer_list<BoardInput> list)
{
    return list;
}

const QByteArray lcd =
    "300 ; base\n7 ; interrupt\n0\n0\n10 ; dividers\n100\n3 ; seconds\n2.5 ; gate\n0\n1\nG\nUTT.P\nOD\n"
    "UPTT\n";
const QByteArray pse = QByteArray("1\n").repeated(28) + "60\n1\n1\n0\n1\n";
const QByteArray par =
    "Supply V - U 1 A 10 - 10 14 - 0 1\nTemp C - T 1 A 20 - -60 60 - 0 1\nTemp C - t 2 A 0 - -60 60 - 0 1\n"
    "Pressure mm - P 1 A 0 - 600 800 - 0 1\nRadiation mkR - G 1 A 0 - 0 99 - 0 1\n"
    "Door - - D 1 A 0 - 0 1 - 0.5\n";

} // namespace

/// Boards, the gamma sensor, and all files of a station held against each other.
class TestStationConfig : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boardL154()
    {
        Complaints complaints;
        const auto board = readBoard(BoardKind::L154, QStringLiteral("ACK.LCD"), lcd, complaints);
        QCOMPARE(texts(complaints.list()), QStringList());
        QVERIFY(board);
        QCOMPARE(board->switchRate, 1000.0);
        QCOMPARE(board->channelRate(), 250.0);
        QCOMPARE(board->instantSeconds, 3);
        QCOMPARE(board->gate, 2.5);
        QVERIFY(!board->isTest);
        QVERIFY(board->sendsInstant);
        QCOMPARE(board->frequency, (ParameterId{u'G', 1}));
        QCOMPARE(board->analogue, inputs({{0, {u'U', 1}}, {1, {u'T', 1}}, {2, {u'T', 2}}, {4, {u'P', 1}}}));
        QCOMPARE(board->digital, inputs({{0, {u'O', 1}}, {1, {u'D', 1}}}));
        QCOMPARE(board->order, inputs({{0, {u'U', 1}}, {1, {u'P', 1}}, {2, {u'T', 1}}, {3, {u'T', 2}}}));
    }

    void boardFastwel_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("hardwareAverage");
        QTest::newRow("a value a line") << QByteArray("300 a\n7 b\n0\n0\n500 c\n2 d\n4\n1\n0\nUT\n-\nTU\n") << 4;
        QTest::newRow("in one line") << QByteArray("300 7 0 0 500 2 4 1 0 UT - TU") << 4;
        QTest::newRow("built in, a value a line") << QByteArray("300 a\n0\n500\n2\n4\n1\n0\nUT\n-\nTU x\n") << 8;
        QTest::newRow("built in, in two lines") << QByteArray("300 0 500 2 4 1 0\nUT - TU") << 8;
        QTest::newRow("Cyrillic letters") << QByteArray("300 0 500 2 4 1 0\nUТ - ТU") << 8;
    }

    void boardFastwel()
    {
        QFETCH(const QByteArray, bytes);
        Complaints complaints;
        const auto board = readBoard(BoardKind::Fastwel, QStringLiteral("ACK.FWL"), bytes, complaints);
        QCOMPARE(texts(complaints.list()), QStringList());
        QVERIFY(board);
        QCOMPARE(board->switchRate, 2000.0);
        QTEST(board->hardwareAverage, "hardwareAverage");
        QCOMPARE(board->instantSeconds, 4);
        QVERIFY(board->isTest);
        QCOMPARE(board->analogue, inputs({{0, {u'U', 1}}, {1, {u'T', 1}}}));
        QVERIFY(board->digital.isEmpty());
        QCOMPARE(board->order, inputs({{0, {u'T', 1}}, {1, {u'U', 1}}}));
    }

    void faultyBoards_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("complaint");
        const auto row = [](const char *name, BoardKind kind, const char *bytes, const char *complaint) {
            QTest::newRow(name) << static_cast<int>(kind) << QByteArray(bytes) << QString::fromUtf8(complaint);
        };
        row("short LCD", BoardKind::L154, "300 7 0",
            "ACK.X: The file has 3 values instead of 14. The board is left out.");
        row("11 values", BoardKind::Fastwel, "1 2 3 4 5 6 7 8 9 10 11",
            "ACK.X: The file has 11 values instead of 12, or 10 without the AI16-5A. The board is left out.");
        row("divider", BoardKind::L154, "300 7 0 0 0 100 1 1 0 0 - U - U",
            "ACK.X, line 1, field 5 (first divider): “0” is not between 1 and 65535. 1 is used.");
        row("gate", BoardKind::L154, "300\n7\n0\n0\n10\n100\n1\nlong\n0\n0\n-\nU\n-\nU",
            "ACK.X, line 8, field 1 (gate, s): “long” is not a number. 1 is used.");
        row("period", BoardKind::Fastwel, "300 0 fast 0 1 0 0 U - U",
            "ACK.X, line 1, field 3 (period of the timer, µs): “fast” is not a number. 1000 is used.");
        row("letter", BoardKind::Fastwel, "300 0 500 0 1 0 0 U7T - UT",
            "ACK.X, line 1, field 8 (analogue inputs): “7” at place 2 is not a Latin letter. The other letters are "
            "used.");
        row("averaging of the built-in", BoardKind::Fastwel, "300 0 500 4 1 0 0 U - U",
            "ACK.X, line 1, field 4 (averaging in the board): “4” is not between 0 and 3. 0 is used.");
    }

    void faultyBoards()
    {
        QFETCH(const int, kind);
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, complaint);
        Complaints complaints;
        readBoard(static_cast<BoardKind>(kind), QStringLiteral("ACK.X"), bytes, complaints);
        QCOMPARE(texts(complaints.list()), QStringList{complaint});
    }

    void gamma()
    {
        Complaints complaints;
        GammaConfig expected;
        expected.parameter = {u'G', 1};
        expected.gate = 10s;
        expected.inputBit = 3;
        expected.blinkerBit = 5;
        expected.checkAt = 480min;
        expected.sensitivity = 2.5;
        expected.background = 0.75;
        QCOMPARE(readGamma(QStringLiteral("ACK.GAM"), "G 10 3 5 480 2.5 0.75", complaints), expected);
        QCOMPARE(
            readGamma(QStringLiteral("ACK.GAM"), "G code\n10 s\n3 bit\n5\n480\n2.5\n0.75 Hz\n", complaints), expected);
        QCOMPARE(texts(complaints.list()), QStringList());
        QVERIFY(!readGamma(QStringLiteral("ACK.GAM"), "7 10 32 5 1440 x 0.75", complaints));
        QVERIFY(!readGamma(QStringLiteral("ACK.GAM"), "G 10", complaints));
        const QString end = QStringLiteral(" The gamma sensor is left out.");
        QCOMPARE(
            texts(complaints.list()),
            QStringList({
                QStringLiteral("ACK.GAM, line 1, field 1 (code): “7” is not a code: a Latin letter, with a number if "
                               "need be.")
                    + end,
                QStringLiteral("ACK.GAM, line 1, field 3 (input bit): “32” is not between 0 and 31.") + end,
                QStringLiteral("ACK.GAM, line 1, field 5 (minute of the check): “1440” is not between 0 and 1439.")
                    + end,
                QStringLiteral("ACK.GAM, line 1, field 6 (sensitivity): “x” is not a number.") + end,
                QStringLiteral("ACK.GAM: The file has 2 values instead of 7.") + end,
            }));
    }

    void whole()
    {
        const StationReading reading = readStation(
            {{QStringLiteral("ACK.INI"), "1 60 x\n1 0 w\n"},
             {QStringLiteral("ACK.PAR"), par},
             {QStringLiteral("ACK.PSE"), pse},
             {QStringLiteral("ACK.LCD"), lcd},
             {QStringLiteral("ACK.GAM"), "G 10 3 5 480 2.5 0.75"},
             {QStringLiteral("INPUT.P01"), "~t02\n5 1"},
             {QStringLiteral("REAL.T02"), "c0 1"}});
        QCOMPARE(reading.complaints.size(), 1); // what is without effect in ACK.PSE
        const StationConfig &config = reading.config;
        QCOMPARE(config.parameters.size(), 6);
        QCOMPARE(config.corrections.size(), 6);
        QCOMPARE(config.corrections[3].inputThermometer, (ParameterId{u't', 2}));
        QCOMPARE(config.corrections[2].real.byTemperature, (QList<QList<double>>{{1}}));
        QCOMPARE(config.thermometer(), 1);
        QCOMPARE(config.indexOf({u'T', 2}), 2);
        QCOMPARE(config.indexOf({u't', 1}), 1);
        QCOMPARE(config.indexOf({u'Z', 1}), -1);
        QCOMPARE(config.processingOrder(), (QList<int>{0, 3, 1, 2, 4, 5}));
        QCOMPARE(config.averaging(0), 10s);
        QCOMPARE(config.averaging(3), 1s); // line 28 of ACK.PSE
        QCOMPARE(config.instantSeconds(4), 3);
        QVERIFY(!config.isTest());
        QCOMPARE(config.precipitationBit(), 0);
        QVERIFY(config.gamma);
    }

    void theSecondBoardCountsOn()
    {
        const StationReading reading = readStation(
            {{QStringLiteral("ACK.PAR"), par},
             {QStringLiteral("ACK.LCD"), lcd},
             {QStringLiteral("ACK.FWL"), "300 0 500 2 4 1 0 TP DO PT"}});
        const BoardConfig &second = reading.config.boards.at(1);
        QCOMPARE(second.analogue, inputs({{0, {u'T', 3}}, {1, {u'P', 2}}}));
        QCOMPARE(second.digital, inputs({{0, {u'D', 2}}, {1, {u'O', 2}}}));
        QCOMPARE(second.order, inputs({{0, {u'P', 2}}, {1, {u'T', 3}}}));
        QCOMPARE(reading.config.bitOf(1, second.digital[0]), 8);
        QVERIFY(reading.config.isTest());
    }

    /// The supply goes first whatever the board says; what it does not name follows as in ACK.PAR.
    void orderOfProcessing()
    {
        const StationReading reading =
            readStation({{QStringLiteral("ACK.PAR"), par}, {QStringLiteral("ACK.FWL"), "300 0 500 2 4 1 0 UTP - PT"}});
        QCOMPARE(reading.config.processingOrder(), (QList<int>{0, 3, 1, 2, 4, 5}));
        QCOMPARE(
            readStation({{QStringLiteral("ACK.PAR"), par}}).config.processingOrder(), (QList<int>{0, 1, 2, 3, 4, 5}));
    }

    void filesThatDoNotFit()
    {
        const QStringList found = texts(readStation({{QStringLiteral("ACK.INI"), "2 60 x\n1 0 w\n1 0 a\n"},
                                                     {QStringLiteral("ACK.PAR"), "- - - P 1 A 0 - - - - 0 1\n"},
                                                     {QStringLiteral("ACK.PSE"), pse},
                                                     {QStringLiteral("ACK.FWL"), "300 0 500 2 4 1 0 PQ O P"},
                                                     {QStringLiteral("ACK.GAM"), "G 10 3 5 480 2.5 0.75"},
                                                     {QStringLiteral("INPUT.P01"), "~f01\n5 1"},
                                                     {QStringLiteral("METEO.P01"), "5 1"},
                                                     {QStringLiteral("REAL.Z03"), "5 1"}})
                                            .complaints);
        QCOMPARE(
            found.mid(1),
            QStringList({
                QStringLiteral("ACK.GAM: ACK.PAR has no parameter G 1. The gamma sensor is left out."),
                QStringLiteral("INPUT.P01, line 1: ACK.PAR has no parameter f 1. Nothing is added."),
                QStringLiteral("METEO.P01: ACK.PAR has no thermometer, a parameter with the code T. Nothing is added."),
                QStringLiteral("REAL.Z03: ACK.PAR has no parameter Z 3. The file is not used."),
                QStringLiteral("ACK.INI, line 1: The object that gathers has the number 2 and the station, by ACK.PSE, "
                               "1. It gathers all the same."),
                QStringLiteral("ACK.INI, line 2: The source needs the file ACK.LCD. It measures nothing."),
                QStringLiteral("ACK.FWL: ACK.PAR has no parameter Q 1. Its input is not used."),
            }));
    }

    void nothingAtAll()
    {
        QCOMPARE(
            texts(readStation({}).complaints),
            QStringList({
                QStringLiteral("ACK.PSE: The file is missing. The usual settings are used."),
                QStringLiteral("ACK.INI: The file is missing. The station has neither sources nor lines."),
                QStringLiteral("ACK.PAR: The file is missing. The station has no parameters."),
            }));
    }

    void folder()
    {
        const QTemporaryDir folder;
        const auto write = [&folder](const char *name, const QByteArray &bytes) {
            QFile file(folder.filePath(QString::fromUtf8(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes);
        };
        write("аск.Ini", "1 60 x\n"); // Cyrillic
        write("ACK.PAR", par);
        write("Аck.pse", pse); // mixed
        write("meteo.т01", "5 1\n"); // Cyrillic
        write("input.P01", QByteArray(1024 * 1024 + 1, ' '));
        write("readme.txt", "x");
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("ACK.GAM")));
        write("АСК.PAR", par);
        QList<StationComplaint> complaints;
        const StationFiles files = readStationFolder(folder.path(), complaints);
        QCOMPARE(
            files.keys(),
            QStringList(
                {QStringLiteral("ACK.INI"), QStringLiteral("ACK.PAR"), QStringLiteral("ACK.PSE"),
                 QStringLiteral("METEO.T01")}));
        QCOMPARE(files.value(QStringLiteral("ACK.PAR")), par);
        QCOMPARE(
            texts(complaints),
            QStringList({
                QStringLiteral("input.P01: The file is longer than 1 MiB. The file is not used."),
                QStringLiteral("АСК.PAR: Another file of the folder is ACK.PAR already. The file is not used."),
            }));
        const StationReading reading = readStationIn(folder.path());
        QCOMPARE(reading.config.parameters.size(), 6);
        QCOMPARE(reading.complaints.size(), 3);
    }

    /// A whole station as files, in three encodings.
    void example()
    {
        const StationReading reading = readStationIn(QStringLiteral(GORIZONT_TEST_DATA "/station"));
        QCOMPARE(
            texts(reading.complaints),
            QStringList{
                QStringLiteral("ACK.PSE: The values 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 17, 18, 19, 20, "
                               "25, 27 are without effect here.")});
        const StationConfig &config = reading.config;
        QStringList names;
        for (const ParameterConfig &parameter : config.parameters) {
            names.append(parameter.name);
        }
        QCOMPARE(
            names,
            QStringList(
                {QStringLiteral("Напряжение питания"), QStringLiteral("Температура воздуха"),
                 QStringLiteral("Температура почвы"), QStringLiteral("Атм. давление"), QStringLiteral("Влажность"),
                 QStringLiteral("Направление ветра"), QStringLiteral("Скорость ветра"), QStringLiteral("Гамма-фон"),
                 QStringLiteral("Дверь шкафа")}));
        QCOMPARE(config.objects.size(), 5);
        QCOMPARE(config.boards.size(), 2);
        QCOMPARE(config.boards[0].switchRate, 4000.0);
        QCOMPARE(config.boards[0].channelRate(), 1000.0);
        QCOMPARE(config.corrections[3].input.rows.size(), 2);
        QCOMPARE(config.corrections[3].real.byTemperature.size(), 2);
        QCOMPARE(config.corrections[1].real.table.rows.size(), 2);
        QCOMPARE(config.processingOrder(), (QList<int>{0, 1, 3, 4, 5, 6, 2, 7, 8}));
        QCOMPARE(config.instantSeconds(2), 4);
        QVERIFY(config.gamma);
    }

    void noFolder()
    {
        const StationReading reading = readStationIn(QStringLiteral("/does/not/exist"));
        QCOMPARE(reading.complaints.first().text(), QStringLiteral("/does/not/exist: The folder does not exist. Nothing is measured."));
    }
};

QTEST_GUILESS_MAIN(TestStationConfig)
#include "tst_stationconfig.moc"
