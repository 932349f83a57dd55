#include "core/files/recordfile.h"
#include "core/history/historywriter.h"
#include "core/history/samplerepair.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <array>

#include <unistd.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr int samplesPerBlock = 32;
constexpr int packetsPerPair = 3;

void report(const QByteArray &line)
{
    const QByteArray bytes = line + '\n';
    if (::write(STDOUT_FILENO, bytes.constData(), static_cast<size_t>(bytes.size())) != bytes.size()) {
        std::abort();
    }
}

/// What is killed: writes as fast as it can, and tells its parent about every record that is finished.
int writeUntilKilled(const QString &folder, int round)
{
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    line.sensors = {accelerometer(1)};
    HistoryConfig config;
    config.folder = folder;
    config.saveInterval = 10ms;
    config.ringPackets = packetsPerPair;
    config.lines = {line};
    config.zone = moscowZone();
    const UtcTime start = moscow("2018-02-01T00:00:00") + round * 24h;
    HistoryWriter writer(config, [start] { return start; });
    QObject::connect(&writer, &HistoryWriter::dataLineWritten, [](const QString &text) {
        report("data " + text.toLatin1());
    });
    int count = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&writer, &count, start] {
        Reading reading;
        reading.number = 1;
        reading.tilt = Tilt{count * 1.0, 0};
        writer.updateReadings({reading});
        writer.appendJournal({JournalKind::Info, start, QString::number(count)});
        const auto first = static_cast<qint16>(count * samplesPerBlock);
        writer.appendBlock(samples(1, start + count * 3200ms, first, samplesPerBlock));
        writer.flush();
        report("step " + QByteArray::number(count++));
    });
    writer.start();
    timer.start(0);
    return QCoreApplication::exec();
}

QByteArrayList lines(const QByteArray &text)
{
    QByteArrayList result = text.split('\n');
    result.removeLast(); // what follows the last line feed: nothing, or a line that was never finished
    return result;
}

} // namespace

class TestKillWriting : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingReportedIsLost();

private:
    QByteArrayList runAndKill(int round);
    void checkText(const QString &name, const QByteArray &before, const QByteArrayList &reported);
    void checkSamples(int round, qsizetype blocks);
    QByteArray content(const QString &name) const { return readAll(m_folder.filePath(name)); }

    QTemporaryDir m_folder;
};

void TestKillWriting::nothingReportedIsLost()
{
    const QString data = QStringLiteral("2018_02_data.txt");
    const QString log = QStringLiteral("2018_02_log.txt");
    for (int round = 0; round < 20; ++round) {
        const QByteArray dataBefore = content(data);
        const QByteArray logBefore = content(log);
        QByteArrayList dataLines;
        QByteArrayList logLines;
        for (const QByteArray &line : runAndKill(round)) {
            if (line.startsWith("data ")) {
                dataLines.append(line.mid(5) + '\r');
            } else {
                const QByteArray day = QByteArray::number(round + 1).rightJustified(2, '0');
                logLines.append("0 00:00:00 " + day + ".02.18   " + line.mid(5) + '\r');
            }
        }
        QVERIFY(!logLines.isEmpty());
        checkText(data, dataBefore, dataLines);
        checkText(log, logBefore, logLines);
        checkSamples(round, logLines.size());
        if (QTest::currentTestFailed()) {
            qWarning("round %d", round);
            return;
        }
    }
    QVERIFY(content(data).count('\n') > 20); // the timer too was interrupted at work
}

QByteArrayList TestKillWriting::runAndKill(int round)
{
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(
        QCoreApplication::applicationFilePath(), {QStringLiteral("--write"), m_folder.path(), QString::number(round)});
    if (!child.waitForReadyRead(30'000)) {
        return {};
    }
    QTest::qSleep(static_cast<int>(QRandomGenerator::global()->bounded(10, 120)));
    child.kill();
    child.waitForFinished(30'000);
    return lines(child.readAllStandardOutput());
}

/// At most one record may have been written without having been reported.
void TestKillWriting::checkText(const QString &name, const QByteArray &before, const QByteArrayList &reported)
{
    RecordFile file;
    QVERIFY(file.prepare(m_folder.filePath(name)) == RecordFile::State::Opened);
    const QByteArray after = content(name);
    QVERIFY(after.startsWith(before));
    const QByteArrayList written = lines(after.mid(before.size()));
    QVERIFY(written.size() == reported.size() || written.size() == reported.size() + 1);
    QCOMPARE(written.first(reported.size()), reported);
    for (const QByteArray &line : written) {
        QVERIFY2(line.endsWith('\r'), line);
    }
}

/// All pairs of this round one after another are the numbers from 0 up without a hole.
void TestKillWriting::checkSamples(int round, qsizetype blocks)
{
    const QDir folder(m_folder.filePath(QStringLiteral("Bin")));
    repairSampleFiles(folder.path());
    const QString day = QStringLiteral("18_02_%1_*").arg(round + 1, 2, 10, QChar(u'0'));
    std::array<QByteArray, 2> axes;
    for (const QString &name : folder.entryList({day + QStringLiteral("X.wrd")}, QDir::Files, QDir::Name)) {
        const QByteArray x = readAll(folder.filePath(name));
        const QByteArray y = readAll(folder.filePath(name.chopped(5) + QStringLiteral("Y.wrd")));
        QCOMPARE(x.size(), y.size());
        QVERIFY(x.size() <= qsizetype{packetsPerPair} * samplesPerBlock * 2);
        axes[0] += x;
        axes[1] += y;
    }
    QVERIFY(axes[0].size() >= blocks * samplesPerBlock * 2);
    for (qsizetype i = 0; i < axes[0].size() / 2; ++i) {
        const auto low = static_cast<char>(i & 0xFF);
        const auto high = static_cast<char>((i >> 8) & 0xFF);
        QVERIFY(axes[0].at(2 * i) == low && axes[0].at(2 * i + 1) == high);
    }
}

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == u"--write") {
        return writeUntilKilled(arguments.value(2), arguments.value(3).toInt());
    }
    TestKillWriting test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_killwriting.moc"
