#include "core/station/service/rawmapping.h"
#include "core/station/sources/recordedsource.h"
#include "core/station/sources/simulatedsource.h"
#include "core/station/sources/sourcefile.h"
#include "core/station/sources/sysfssource.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont::station;
using namespace std::chrono_literals;

namespace {

SourcePlan read(const QByteArray &text, QList<StationComplaint> *complaints = nullptr)
{
    Complaints found;
    const SourcePlan plan = readSources(QStringLiteral("ACK.SRC"), text, QStringLiteral("/station"), found);
    if (complaints) {
        *complaints = found.list();
    }
    return plan;
}

RawSample sampleAt(Source &source, double seconds, quint32 outputs = 0)
{
    RawSample sample;
    const QString problem = source.measure({std::chrono::duration<double>(seconds), 0, outputs}, sample);
    if (!problem.isEmpty()) {
        qWarning("%s", qPrintable(problem));
    }
    return sample;
}

void write(const QString &path, const QByteArray &text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
}

} // namespace

class TestStationSources : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void calculatesSignals();
    void addsNoise();
    void turnsTheVane();
    void pulsesWhileAnOutputIsOn();
    void complainsOfALine_data();
    void complainsOfALine();
    void takesTheMeanOfASecond();
    void replaysARecording();
    void refusesARecording_data();
    void refusesARecording();
    void readsIio();
    void countsPulsesOfAFile();
    void saysWhichFileIsGone();
    void putsChannelsToParameters();
};

void TestStationSources::calculatesSignals()
{
    SimulatedSource source(read("a1 constant 12.5\n"
                                "a2 sine 1 2 60 90 ; one full swing a minute, at its top at the start\n"
                                "A3 drop 12 8 100 20\n"
                                "d2 square 0 1 10 5\n"
                                "a1 constant -0.5\n"
                                "f1 constant 40\n"));
    QCOMPARE(sampleAt(source, 0).analogue[0], std::optional(12.0));
    QCOMPARE(sampleAt(source, 0).analogue[1], std::optional(3.0));
    QVERIFY(qAbs(*sampleAt(source, 30).analogue[1] + 1.0) < 1e-9);
    QCOMPARE(sampleAt(source, 79.9).analogue[2], std::optional(12.0));
    QCOMPARE(sampleAt(source, 80).analogue[2], std::optional(4.0));
    QCOMPARE(sampleAt(source, 100).analogue[2], std::optional(12.0));
    QCOMPARE(sampleAt(source, 4.9).digital[1], std::optional(false));
    QCOMPARE(sampleAt(source, 5).digital[1], std::optional(true));
    QCOMPARE(sampleAt(source, 5).frequency, std::optional(40.0));
    QVERIFY(!sampleAt(source, 0).analogue[3]);
    QVERIFY(!sampleAt(source, 0).digital[0]);
}

void TestStationSources::addsNoise()
{
    const Signal noise{Signal::Kind::Noise, 5, 2, 1, 0};
    double sum = 0;
    double squares = 0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        const double value = noise.value(0s, static_cast<quint64>(i), 3);
        sum += value;
        squares += (value - 5) * (value - 5);
    }
    QVERIFY2(qAbs(sum / count - 5) < 0.06, QByteArray::number(sum / count)); // four times σ of the mean
    QVERIFY(qAbs(squares / count - 4) < 0.2);
    QCOMPARE(noise.value(0s, 7, 3), noise.value(9s, 7, 3));
    QVERIFY(noise.value(0s, 7, 3) != noise.value(0s, 7, 4));
}

void TestStationSources::turnsTheVane()
{
    SimulatedSource source(read("v2 vane 50 10 355 20 40\n"));
    QVERIFY(!sampleAt(source, 0).winds[0].frequency);
    QCOMPARE(sampleAt(source, 0).winds[1], (WindRaw{50.0, 355.0}));
    QCOMPARE(sampleAt(source, 10).winds[1].frequency, std::optional(60.0));
    bool isBeyondNorth = false;
    for (int second = 0; second < 100; ++second) {
        const double phase = *sampleAt(source, second).winds[1].phase;
        QVERIFY(phase >= 0 && phase < 360 && (phase >= 334.9 || phase <= 15.1));
        isBeyondNorth = isBeyondNorth || phase <= 15.1;
    }
    QVERIFY(isBeyondNorth);
}

void TestStationSources::pulsesWhileAnOutputIsOn()
{
    SimulatedSource source(read("p3 constant 20\np3 output 500 4\n"));
    QCOMPARE(sampleAt(source, 0).pulses[2], std::optional(20.0));
    QCOMPARE(sampleAt(source, 0, 1u << 4).pulses[2], std::optional(520.0));
    QCOMPARE(sampleAt(source, 0, 1u << 3).pulses[2], std::optional(20.0));
}

void TestStationSources::complainsOfALine_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("field");
    QTest::newRow("no channel") << QByteArray("x1 constant 1") << 1;
    QTest::newRow("channel 0") << QByteArray("a0 constant 1") << 1;
    QTest::newRow("channel 65") << QByteArray("a65 constant 1") << 1;
    QTest::newRow("digital 33") << QByteArray("d33 constant 1") << 1;
    QTest::newRow("no signal") << QByteArray("a1 wobble 1") << 2;
    QTest::newRow("no number") << QByteArray("a1 constant high") << 3;
    QTest::newRow("too few") << QByteArray("a1 sine 1 2") << 4;
    QTest::newRow("too many") << QByteArray("a1 constant 1 2") << 4;
    QTest::newRow("period 0") << QByteArray("a1 sine 1 2 0") << 5;
    QTest::newRow("rate 0") << QByteArray("rate 0") << 2;
    QTest::newRow("rate too high") << QByteArray("rate 1001") << 2;
    QTest::newRow("vane on a voltage") << QByteArray("a1 vane 1 1 1 1 1") << 2;
    QTest::newRow("voltage on a vane") << QByteArray("v1 constant 1") << 2;
    QTest::newRow("vane, period 0") << QByteArray("v1 vane 1 1 1 1 0") << 7;
    QTest::newRow("output without file") << QByteArray("o1 constant 1") << 2;
    QTest::newRow("output bit") << QByteArray("p1 output 5 32") << 4;
    QTest::newRow("iio without input") << QByteArray("a1 iio /dev/x") << 3;
    QTest::newRow("iio, no input") << QByteArray("a1 iio /dev/x two") << 4;
    QTest::newRow("iio of a digital input") << QByteArray("d1 iio /dev/x 1") << 2;
    QTest::newRow("record without file") << QByteArray("record") << 1;
    QTest::newRow("record, what then") << QByteArray("record x.txt twice") << 3;
}

void TestStationSources::complainsOfALine()
{
    QFETCH(QByteArray, line);
    QFETCH(int, field);
    QList<StationComplaint> complaints;
    const SourcePlan plan = read("; a comment\na1 constant 1\n" + line + "\na2 constant 2\n", &complaints);
    QCOMPARE(complaints.size(), 1);
    QCOMPARE(complaints.constFirst().file, QStringLiteral("ACK.SRC"));
    QCOMPARE(complaints.constFirst().line, 3);
    QCOMPARE(complaints.constFirst().field, field);
    QVERIFY(!complaints.constFirst().problem.isEmpty());
    QCOMPARE(plan, read("a1 constant 1\na2 constant 2\n")); // the others are used
}

void TestStationSources::takesTheMeanOfASecond()
{
    SampleMean mean;
    QVERIFY(!mean.take());
    RawSample first;
    first.analogue[0] = 1;
    first.analogue[1] = 7;
    first.digital[0] = true;
    first.winds[0] = {10.0, 350.0};
    RawSample second;
    second.analogue[0] = 4;
    second.digital[0] = false;
    second.winds[0] = {20.0, 10.0};
    mean.add(first);
    mean.add(second);
    const auto taken = mean.take();
    QVERIFY(taken);
    QCOMPARE(taken->analogue[0], std::optional(2.5));
    QCOMPARE(taken->analogue[1], std::optional(7.0));
    QVERIFY(!taken->analogue[2]);
    QCOMPARE(taken->digital[0], std::optional(false));
    QCOMPARE(taken->winds[0], (WindRaw{20.0, 10.0}));
    QVERIFY(!mean.take());
}

void TestStationSources::replaysARecording()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("day.txt"));
    write(
        path,
        "time a1 d1 v1.speed v1.direction f1 ; of a good day\n"
        "100  1.5 0 10 20 5\n"
        "102  2,5 1 -  30 -\n");
    for (const bool isRepeated : {true, false}) {
        RecordedSource source({path, isRepeated}, 10);
        QCOMPARE(source.open(), QString());
        QCOMPARE(sampleAt(source, 0).analogue[0], std::optional(1.5));
        QCOMPARE(sampleAt(source, 1.9).analogue[0], std::optional(1.5));
        QCOMPARE(sampleAt(source, 0).winds[0], (WindRaw{10.0, 20.0}));
        QCOMPARE(sampleAt(source, 2).analogue[0], std::optional(2.5));
        QCOMPARE(sampleAt(source, 2).winds[0], (WindRaw{std::nullopt, 30.0}));
        QVERIFY(!sampleAt(source, 2).frequency);
        QCOMPARE(sampleAt(source, 2).digital[0], std::optional(true));
        QCOMPARE(sampleAt(source, 4.5).analogue[0], isRepeated ? std::optional(1.5) : std::nullopt);
    }
}

void TestStationSources::refusesARecording_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("no values") << QByteArray("time a1\n");
    QTest::newRow("no time") << QByteArray("a1 a2\n1 2\n");
    QTest::newRow("no channel") << QByteArray("time z9\n1 2\n");
    QTest::newRow("an output") << QByteArray("time o1\n1 2\n");
    QTest::newRow("half a wind") << QByteArray("time v1\n1 2\n");
    QTest::newRow("wind of another kind") << QByteArray("time v1.gust\n1 2\n");
    QTest::newRow("part of a voltage") << QByteArray("time a1.speed\n1 2\n");
    QTest::newRow("a value too few") << QByteArray("time a1 a2\n1 2\n");
    QTest::newRow("no number") << QByteArray("time a1\n1 two\n");
    QTest::newRow("time goes back") << QByteArray("time a1\n1 2\n1 3\n");
}

void TestStationSources::refusesARecording()
{
    QFETCH(QByteArray, text);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("day.txt"));
    write(path, text);
    RecordedSource source({path, true}, 10);
    QVERIFY(!source.open().isEmpty());
}

/// The kernel's ABI: voltage in mV = (raw + offset) × scale.
void TestStationSources::readsIio()
{
    QTemporaryDir folder;
    const QDir dir(folder.path());
    write(dir.filePath(QStringLiteral("in_voltage0_raw")), "2048\n");
    write(dir.filePath(QStringLiteral("in_voltage_scale")), "0.5\n");
    write(dir.filePath(QStringLiteral("in_voltage3_raw")), "-100\n");
    write(dir.filePath(QStringLiteral("in_voltage3_scale")), "2\n");
    write(dir.filePath(QStringLiteral("in_voltage3_offset")), "600\n");
    write(dir.filePath(QStringLiteral("gpio")), "1\n");
    const QByteArray path = QFile::encodeName(folder.path());
    SysfsSource source(read("a1 iio " + path + " 0\na2 iio " + path + " 3\nd4 file " + path + "/gpio\n"));
    QCOMPARE(source.open(), QString());
    const RawSample sample = sampleAt(source, 0);
    QCOMPARE(*sample.analogue[0], 1.024); // 2048 × 0.5 mV
    QCOMPARE(*sample.analogue[1], 1.0); // (−100 + 600) × 2 mV
    QCOMPARE(sample.digital[3], std::optional(true));
    write(dir.filePath(QStringLiteral("in_voltage0_raw")), "4096\n");
    write(dir.filePath(QStringLiteral("gpio")), "0\n");
    QCOMPARE(*sampleAt(source, 1).analogue[0], 2.048);
    QCOMPARE(sampleAt(source, 1).digital[3], std::optional(false));
}

void TestStationSources::countsPulsesOfAFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("count"));
    write(path, "1000");
    SysfsSource source(read("p1 file " + QFile::encodeName(path) + "\n"));
    QCOMPARE(source.open(), QString());
    QVERIFY(!sampleAt(source, 0).pulses[0]);
    write(path, "1050");
    QCOMPARE(sampleAt(source, 2).pulses[0], std::optional(25.0));
    write(path, "5"); // the counter began anew
    QVERIFY(!sampleAt(source, 3).pulses[0]);
    write(path, "9");
    QCOMPARE(sampleAt(source, 4).pulses[0], std::optional(4.0));
}

void TestStationSources::saysWhichFileIsGone()
{
    QTemporaryDir folder;
    const QString raw = folder.filePath(QStringLiteral("in_voltage0_raw"));
    write(raw, "1");
    SysfsSource source(read("a1 iio " + QFile::encodeName(folder.path()) + " 0\n"));
    QCOMPARE(source.open(), QString());
    RawSample sample;
    QCOMPARE(source.measure({}, sample), QString());
    write(raw, "none");
    QVERIFY(source.measure({}, sample).contains(QStringLiteral("in_voltage0_raw")));
    QVERIFY(QFile::remove(raw));
    QVERIFY(source.measure({}, sample).contains(QStringLiteral("in_voltage0_raw")));
    SysfsSource missing(read("a1 iio /there/is/nothing 0\n"));
    QVERIFY(missing.open().contains(QStringLiteral("nothing")));
}

/// Letters of the two boards, the frequency input, the digital inputs and two winds.
void TestStationSources::putsChannelsToParameters()
{
    StationFiles files;
    files[QStringLiteral("ACK.PSE")] = "1\n";
    files[QStringLiteral("ACK.PAR")] = "s V s T 1 A 0 %4.1f 0 9 - 0 1\n"
                                       "s V s P 1 A 0 %4.1f 0 9 - 0 1\n"
                                       "s V s T 2 A 0 %4.1f 0 9 - 0 1\n"
                                       "s V s G 1 A 0 %4.1f 0 9 - 0 1\n"
                                       "s V s A 1 A 0 %4.1f 0 9 - 0 1\n"
                                       "s V s M 2 A 0 %4.1f 0 9 - 0 1\n";
    files[QStringLiteral("ACK.LCD")] = "300\n5\n0\n0\n1\n1000\n1\n1\n0\n0\nG\n-TP\n-O\nTP\n";
    files[QStringLiteral("ACK.FWL")] = "300\n5\n0\n0\n1000\n0\n1\n0\n0\n-T\n-\nT\n";
    const StationConfig config = readStation(files).config;
    QCOMPARE(config.parameters.size(), 6);
    QCOMPARE(config.boards.size(), 2);
    RawSample sample;
    sample.analogue[1] = 1.25;
    sample.analogue[2] = 2.5;
    sample.analogue[33] = 3.75;
    sample.frequency = 40;
    sample.digital[1] = true;
    sample.digital[0] = false;
    sample.winds[0] = {7.0, 90.0};
    sample.winds[1] = {8.0, 180.0};
    const RawSecond second = secondOf(config, sample);
    const std::vector<std::optional<double>> expected{1.25, 2.5, 3.75, 40.0, 90.0, 8.0};
    QCOMPARE(second.raw, expected);
    QCOMPARE(second.digital, std::optional<quint32>(2));
    QVERIFY(!secondOf(config, {}).digital);
}

QTEST_GUILESS_MAIN(TestStationSources)

#include "tst_stationsources.moc"
