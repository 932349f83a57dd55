#include "tests/core/archive/archivesite.h"

#include <QProcess>
#include <QRandomGenerator>
#include <QTest>

#include <unistd.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr int perCommit = 7;

void report(const QByteArray &line)
{
    const QByteArray bytes = line + '\n';
    if (::write(STDOUT_FILENO, bytes.constData(), static_cast<size_t>(bytes.size())) != bytes.size()) {
        std::abort();
    }
}

/// What is killed: a reading and a block a second, as fast as it can; tells its parent what is committed.
int writeUntilKilled(const QString &file, int first)
{
    ArchiveBench bench(archiveConfig(file));
    bench.open(noon + first * 1s);
    for (int second = first;; ++second) {
        bench.read(1, noon + second * 1s, second);
        bench.writer->appendBlock(sampleBlock(noon + second * 1s, second % 30'000, 10, second > first));
        if (second % perCommit == 0) {
            bench.writer->flush();
            report(QByteArray::number(second));
        }
    }
}

} // namespace

class TestArchiveKill : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingCommittedIsLost();
    void commitsWithinASecond();

private:
    int runAndKill(const QString &file, int first);

    QTemporaryDir m_folder;
};

/// The last second that was committed, as far as the child came to say it; 0: nothing.
int TestArchiveKill::runAndKill(const QString &file, int first)
{
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--write"), file, QString::number(first)});
    if (!child.waitForReadyRead(30'000)) {
        return 0;
    }
    QTest::qSleep(static_cast<int>(QRandomGenerator::global()->bounded(5, 250)));
    child.kill();
    child.waitForFinished(30'000);
    const QByteArray text = child.readAllStandardOutput();
    return text.left(text.lastIndexOf('\n')).split('\n').last().toInt();
}

void TestArchiveKill::nothingCommittedIsLost()
{
    const QString file = m_folder.filePath(QStringLiteral("archive.sqlite"));
    const ArchiveBench bench(archiveConfig(file));
    int next = 1;
    constexpr int closesChunks = 2000; // how many it takes until chunks are closed too
    for (int round = 0; round < 20 || (next <= closesChunks && round < 200); ++round) {
        const int committed = runAndKill(file, next);
        QVERIFY(committed >= next);
        const Buckets all = bench.fullRate({1, Quantity::TiltX}, noon, noon + 10'000h);
        const auto count = static_cast<int>(all.size());
        QVERIFY2(
            count >= committed && count <= committed + 2 * perCommit, qPrintable(QString::number(count - committed)));
        for (int i = 0; i < count; ++i) {
            QVERIFY(all.at(i).from == noon + (i + 1) * 1s && all.at(i).mean == (i + 1) / 256.0);
        }
        ArchiveQuery query(bench.config);
        QCOMPARE(query.blocks(3, noon, noon + 10'000h).size(), all.size());
        quint32 sum = 0;
        for (const SeriesBucket &bucket : bench.ask({1, Quantity::TiltX}, noon, noon + 10'000h, 1).buckets) {
            sum += bucket.count;
        }
        QCOMPARE(sum, static_cast<quint32>(count));
        next = count + 1;
    }
    QVERIFY2(next > closesChunks, qPrintable(QString::number(next)));
}

/// By itself, in an event loop: what a kill can lose is not older than a second.
void TestArchiveKill::commitsWithinASecond()
{
    ArchiveConfig config = archiveConfig(m_folder.filePath(QStringLiteral("other.sqlite")));
    QVERIFY(ArchiveConfig().commitInterval < 1s);
    ArchiveWriter writer(config);
    writer.start();
    const UtcTime now = utcNow();
    writer.updateReadings({tiltReading(1, now, 5)});
    ArchiveQuery query(config);
    const SeriesQuery question{{{1, Quantity::TiltX}}, now, now + 1s, 0};
    QVERIFY(query.series(question).first().buckets.isEmpty());
    QTRY_COMPARE(query.series(question).first().buckets.size(), 1);
    writer.stop();
}

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == u"--write") {
        return writeUntilKilled(arguments.value(2), arguments.value(3).toInt());
    }
    TestArchiveKill test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_archivekill.moc"
