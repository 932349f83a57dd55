#include "core/history/historywriter.h"
#include "core/history/vibrationformat.h"
#include "tests/core/history/historysupport.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray nothing(16, '\t'); ///< eight measurements that are not in use

QDateTime evening()
{
    return localTime(moscow("2018-02-07T18:33:03"), moscowZone());
}

Reading answer(int number)
{
    Reading reading;
    reading.number = number;
    reading.isAnswer = true;
    reading.status = 0x0700;
    const VibrationMeasurement rms{0, 1, 70.71068, 45.0, false, false, false, {}, false};
    const VibrationMeasurement speed{2, 5, 1500.0, {}, false, false, false, {}, false};
    const VibrationMeasurement invalid{7, 16, {}, {}, {}, {}, {}, {}, false};
    reading.vibration = Vibration{
        {{0, ChannelState::Good, true, {rms, speed, invalid}},
         {1, ChannelState::ShortCircuit, true, {}},
         {2, ChannelState::Good, false, {rms}},
         {3, ChannelState::NoData, true, {}}},
        {{0, true, true, false, true}, {3, false, false, true, true}, {7, true, false, false, false}}};
    return reading;
}

/// The same, typed.
const QByteArray answered = "\t 0 0111 0000 0000"
                            "\t0\t1\t70.71068\t\t\t5\t1500\t\t\t\t\t\t\t\t\t16\t"
                            "\t1"
    + nothing + "\t" + nothing + "\t65535" + nothing + "\t00001001 00001000 00000001 10000001";

} // namespace

class TestVibrationFormat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void record()
    {
        const QList<SensorColumns> sensors{{tiltSensor(1), {}}, {vibrationModule(2), answer(2)}};
        QCOMPARE(vibrationRecord(evening(), "3330", sensors), "18:33:03 07.02.18\t3330" + answered + "\r\n");
    }

    /// 70 fields whatever is known of a module.
    void moduleThatNeverAnswered()
    {
        Reading silent;
        silent.status = 0x3700;
        const QList<SensorColumns> sensors{{vibrationModule(2), silent}, {vibrationModule(9), answer(9)}};
        const QByteArray text = vibrationRecord(evening(), "3330", sensors);
        QCOMPARE(text, "18:33:03 07.02.18\t3330\t 3 0111 0000 0000" + QByteArray(69, '\t') + answered + "\r\n");
        QCOMPARE(text.count('\t'), 1 + 2 * 70);
    }

    void valueThatIsNoNumber()
    {
        Reading reading = answer(2);
        reading.vibration->channels[0].measurements[0].value = std::numeric_limits<double>::infinity();
        const QByteArray text = vibrationRecord(evening(), "3330", {{vibrationModule(2), reading}});
        QVERIFY(text.contains("\t0\t1\t\t\t\t5\t1500\t"));
    }

    void monthFile() { QCOMPARE(monthFileName(QDate(2018, 2, 7), MonthFile::Vibration), u"2018_02_vdata.txt"); }

    /// One record every TmSave beside that of `_data`; a torn one of a run that was killed is cut off first.
    void written()
    {
        const QTemporaryDir folder;
        writeAll(folder.filePath(QStringLiteral("2018_02_vdata.txt")), "18:33:02 07.02.18\t3330\r\n18:33:03 07.0");
        const qsizetype records = run(folder.path(), true, {tiltSensor(1), vibrationModule(2)});
        const QByteArray text = readAll(folder.filePath(QStringLiteral("2018_02_vdata.txt")));
        const QByteArray one = "18:33:03 07.02.18\t3330" + answered + "\r\n";
        QCOMPARE(text, "18:33:02 07.02.18\t3330\r\n" + one.repeated(records));
        QVERIFY(readAll(folder.filePath(QStringLiteral("2018_02_log.txt"))).contains("2018_02_vdata.txt"));
    }

    void notWithoutAModule()
    {
        const QTemporaryDir folder;
        run(folder.path(), true, {tiltSensor(1)});
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("2018_02_data.txt"))));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("2018_02_vdata.txt"))));
    }

    void notWithoutCanSave()
    {
        const QTemporaryDir folder;
        run(folder.path(), false, {vibrationModule(2)});
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("2018_02_vdata.txt"))));
    }

private:
    /// A writer for a few records; returns how many.
    qsizetype run(const QString &folder, bool savesFiles, const QList<SensorConfig> &sensors)
    {
        LineConfig line;
        line.index = 1;
        line.isOn = true;
        line.sensors = sensors;
        HistoryConfig config;
        config.folder = folder;
        config.saveInterval = 10ms;
        config.savesFiles = savesFiles;
        config.lines = {line};
        config.zone = moscowZone();
        const UtcTime now = moscow("2018-02-07T18:33:03");
        HistoryWriter writer(config, [now] { return now; });
        connect(&writer, &HistoryWriter::journal, &writer, &HistoryWriter::appendJournal);
        QSignalSpy lines(&writer, &HistoryWriter::dataLineWritten);
        LineStatus open;
        open.port = 1;
        open.state = LineState::Open;
        writer.updateLine(open);
        writer.updateReadings({answer(2)});
        writer.start();
        [&lines] { QTRY_VERIFY(lines.size() >= 3); }();
        writer.stop();
        return lines.size();
    }
};

QTEST_GUILESS_MAIN(TestVibrationFormat)
#include "tst_vibrationformat.moc"
