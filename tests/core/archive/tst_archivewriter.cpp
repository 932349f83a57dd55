#include "core/archive/archivereader.h"
#include "tests/core/archive/archivesite.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <map>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};
constexpr SeriesKey tiltY{1, Quantity::TiltY};

/// Any values that are easy to know again.
int valueAt(int second)
{
    return (second * 37) % 1009 - 300;
}

} // namespace

class TestArchiveWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void keepsEveryReading_data();
    void keepsEveryReading();
    void rollsUpWhatItKeeps();
    void keepsSamples();
    void keepsEvents();
    void keepsRecordsOnce();
    void leavesInvalidValuesOut();
    void roundsTurnedAxes();
    void refusesASecondWriter();
    void explainsAFolderThatCannotBeWritten();
    void refusesTheTablesOfTheFuture();
    void answersInAnotherThread();
    void answersOfNoArchiveAreEmpty();
    void choosesTheCoarsestStep_data();
    void choosesTheCoarsestStep();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("deep/archive.sqlite")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestArchiveWriter::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestArchiveWriter::keepsEveryReading_data()
{
    QTest::addColumn<int>("perCommit");
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("isRestarted");
    QTest::newRow("only the tail") << 1 << 100 << false;
    QTest::newRow("chunks and the tail") << 5 << 1300 << false;
    QTest::newRow("many in a commit") << 700 << 2100 << false;
    QTest::newRow("after a restart") << 5 << 1300 << true;
}

void TestArchiveWriter::keepsEveryReading()
{
    QFETCH(int, perCommit);
    QFETCH(int, count);
    QFETCH(bool, isRestarted);
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    Buckets expected;
    for (int second = 1; second <= count; ++second) {
        const UtcTime time = noon + second * 1s + second * 7us;
        const double value = valueAt(second) / 256.0;
        bench.read(1, time, valueAt(second));
        expected.append({time, value, value, value, 1, 1});
        if (second % perCommit == 0) {
            bench.writer->flush();
        }
        if (isRestarted && second == 900) {
            bench.close();
            bench.open(time);
        }
    }
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 3h), expected);
    QCOMPARE(bench.fullRate(tiltX, expected.at(10).from, expected.at(20).from), expected.mid(10, 10));
    QCOMPARE(bench.fullRate(tiltY, noon, noon + 3h).at(99).mean, -valueAt(100) / 256.0);
    QCOMPARE(bench.fullRate({2, Quantity::TiltX}, noon, noon + 3h), Buckets());
    bench.close();
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 3h), expected);
    QCOMPARE(bench.sentences, QStringList());
}

/// Over the end of the year, a reading every 10 s, against buckets made by hand.
void TestArchiveWriter::rollsUpWhatItKeeps()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    std::map<qint64, QList<double>> hours;
    for (int i = 0; i < 8640; ++i) {
        const UtcTime time = noon + i * 10s;
        bench.read(1, time, valueAt(i));
        hours[(time - noon) / 1h].append(valueAt(i) / 256.0);
        if (i % 90 == 0) {
            bench.writer->flush();
        }
    }
    bench.writer->flush();
    const Series series = bench.ask(tiltX, noon, noon + 24h, 24);
    QCOMPARE(series.step, std::chrono::microseconds(1h));
    QCOMPARE(series.buckets.size(), 24);
    for (qsizetype hour = 0; hour < 24; ++hour) {
        const QList<double> &values = hours[hour];
        const SeriesBucket &bucket = series.buckets.at(hour);
        QVERIFY(bucket.from == noon + hour * 1h);
        QCOMPARE(bucket.minimum, *std::min_element(values.begin(), values.end()));
        QCOMPARE(bucket.maximum, *std::max_element(values.begin(), values.end()));
        const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
        QVERIFY(std::abs(bucket.mean - mean) < 1.0 / 256 / 16);
        QCOMPARE(bucket.count, 360U);
        QCOMPARE(bucket.valid, 360U);
    }
    const Series minutes = bench.ask(tiltX, noon + 10h, noon + 14h, 240);
    QCOMPARE(minutes.step, std::chrono::microseconds(1min));
    QCOMPARE(minutes.buckets.size(), 240);
    QCOMPARE(minutes.buckets.at(7).count, 6U);
    QCOMPARE(bench.ask(tiltX, noon + 10h, noon + 14h, 24).step, std::chrono::microseconds(10min));
    const Series days = bench.ask(tiltX, noon - 12h, noon + 36h, 2);
    QCOMPARE(days.step, std::chrono::microseconds(24h));
    QCOMPARE(days.buckets.size(), 2);
    QCOMPARE(days.buckets.at(0).count + days.buckets.at(1).count, 8640U);
    bench.close();
    QCOMPARE(bench.ask(tiltX, noon, noon + 24h, 24).buckets.size(), 24);
}

void TestArchiveWriter::keepsSamples()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    QList<SampleBlock> expected;
    for (int i = 0; i < 400; ++i) {
        expected.append(sampleBlock(noon + i * 3200ms, i * 32 - 6000, 32, i != 100 && i > 0));
        bench.writer->appendBlock(expected.last());
        bench.now = expected.last().start;
        if (i % 7 == 0) {
            bench.writer->flush();
        }
    }
    bench.writer->flush();
    const auto compare = [&bench, &expected] {
        ArchiveQuery query(bench.config);
        QList<SampleBlock> blocks = query.blocks(3, noon, noon + 1h);
        QCOMPARE(blocks.size(), expected.size());
        for (qsizetype i = 0; i < blocks.size(); ++i) {
            QVERIFY(blocks.at(i).start == expected.at(i).start && blocks.at(i).x == expected.at(i).x);
            QVERIFY(blocks.at(i).y == expected.at(i).y && blocks.at(i).scale == 0.5);
            QCOMPARE(blocks.at(i).followsPrevious, i != 100 && i > 0);
        }

        QCOMPARE(query.blocks(3, noon + 3200ms, noon + 6400ms).size(), 1);
    };
    compare();
    bench.close();
    compare();
    const Buckets values = bench.fullRate({3, Quantity::SampleY}, noon, noon + 3200ms);
    QCOMPARE(values.size(), 32);
    QCOMPARE(values.at(1), (SeriesBucket{noon + 100ms, 2999.5, 2999.5, 2999.5, 1, 1}));
    QCOMPARE(bench.ask({3, Quantity::SampleX}, noon, noon + 20min, 20).buckets.at(1).count, 600U);
}

void TestArchiveWriter::keepsEvents()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    const JournalEntry first{JournalKind::Error, noon + 1s, QStringLiteral("Порт COM3 потерян"), 1, 0};
    const JournalEntry second{JournalKind::Info, noon + 2s, QStringLiteral("again"), 1, 2};
    bench.writer->appendJournal(first);
    bench.writer->appendJournal(second);
    bench.close();
    ArchiveQuery query(bench.config);
    QCOMPARE(query.events(noon, noon + 1h, 10), (QList<JournalEntry>{first, second}));
    QCOMPARE(query.events(noon, noon + 1h, 1), QList<JournalEntry>{second});
    QCOMPARE(query.events(noon + 2s, noon + 1h, 10), QList<JournalEntry>{second});
}

void TestArchiveWriter::keepsRecordsOnce()
{
    const ArchiveConfig config = archiveConfig(file());
    ArchiveStore store(config);
    QVERIFY(store.database().open());
    bool isNew = false;
    const DeviceRecord record{7, noon, QStringLiteral("event 12"), QByteArray("\0\1\2", 3)};
    QVERIFY(store.putRecord(record, &isNew) && isNew);
    QVERIFY(store.putRecord({7, noon, QStringLiteral("event 12"), "other"}, &isNew) && !isNew);
    QVERIFY(store.putRecord({7, noon, QStringLiteral("event 13"), "x"}, &isNew) && isNew);
    ArchiveQuery query(config);
    QCOMPARE(query.records(7, noon, noon + 1s).size(), 2);
    QCOMPARE(query.records(7, noon, noon + 1s).first(), record);
}

void TestArchiveWriter::leavesInvalidValuesOut()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    for (int second = 1; second <= 600; ++second) {
        Reading reading = tiltReading(2, noon + second * 1s, second);
        reading.status = second % 3 == 0 ? 0x0400 : 0; // the tilt is not valid, the temperature is
        bench.writer->updateReadings({reading});
        bench.now = reading.time;
        if (second % 10 == 0) {
            bench.writer->flush();
        }
    }
    bench.close();
    QCOMPARE(bench.fullRate({2, Quantity::TiltX}, noon, noon + 1h).size(), 400);
    QCOMPARE(bench.fullRate({2, Quantity::Temperature}, noon, noon + 1h).size(), 600);
    const SeriesBucket bucket = bench.ask({2, Quantity::TiltX}, noon, noon + 10min, 10).buckets.at(5);
    QCOMPARE(bucket.count, 60U);
    QCOMPARE(bucket.valid, 40U);
}

/// A sensor with RotX measures in no steps: its tilt is kept in 1/1000 of an arc-second, and so is short.
void TestArchiveWriter::roundsTurnedAxes()
{
    ArchiveConfig config = archiveConfig(file());
    config.lines[0].sensors[0].rotationX = 30;
    config.lines[0].sensors[0].offsetX = 0.1;
    ArchiveBench bench(config);
    bench.open(noon);
    for (int second = 0; second < 600; ++second) {
        Reading reading = tiltReading(1, noon + second * 1s, 0);
        reading.tilt = Tilt{1.00125 + second, 100.1 + 0.003 * std::sin(second)};
        bench.writer->updateReadings({reading});
        reading.number = 2;
        bench.writer->updateReadings({reading});
    }
    bench.writer->flush();
    bench.close();
    const Buckets turned = bench.fullRate(tiltX, noon, noon + 1h);
    QCOMPARE(turned.size(), 600);
    QCOMPARE(turned.at(7).mean, 8.001);
    QCOMPARE(bench.fullRate({2, Quantity::TiltX}, noon, noon + 1h).at(7).mean, 8.00125);
    ArchiveDatabase database(bench.config, ArchiveDatabase::Access::Read);
    QVERIFY(database.open());
    const auto size = [&database](int number) {
        return database.single(QStringLiteral("SELECT sum(length(data)) FROM chunk WHERE number = ?"), {number})
            .toInt();
    };
    QVERIFY2(size(1) > 0 && size(1) < 600 * 2 && size(2) > 600 * 5, qPrintable(QString::number(size(1))));
}

void TestArchiveWriter::refusesASecondWriter()
{
    ArchiveBench first(archiveConfig(file()));
    first.open(noon);
    ArchiveBench second(archiveConfig(file()));
    second.open(noon);
    second.read(1, noon + 1s, 9);
    second.writer->flush();
    second.writer->flush();
    QCOMPARE(second.sentences.size(), 1);
    QVERIFY2(second.sentences.first().contains(QStringLiteral("Another copy")), qPrintable(second.sentences.first()));
    first.close();
    second.writer->flush();
    QCOMPARE(second.sentences.last(), QStringLiteral("The archive is being written again."));
    second.close();
    QCOMPARE(second.fullRate(tiltX, noon, noon + 1h).size(), 1);
}

void TestArchiveWriter::explainsAFolderThatCannotBeWritten()
{
    QFile obstacle(m_folder->filePath(QStringLiteral("deep")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.read(1, noon + 1s, 9);
    bench.writer->flush();
    QCOMPARE(bench.sentences.size(), 1);
    QVERIFY(bench.sentences.first().startsWith(QStringLiteral("The archive is not being written: ")));
    obstacle.remove();
    bench.writer->flush();
    bench.close();
    QCOMPARE(bench.fullRate(tiltX, noon, noon + 1h).size(), 1);
}

void TestArchiveWriter::refusesTheTablesOfTheFuture()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.close();
    {
        ArchiveStore store(bench.config);
        QVERIFY(store.database().open());
        QVERIFY(store.database().execute(QStringLiteral("UPDATE meta SET value = 99 WHERE name = 'schema'")));
    }
    bench.open(noon);
    QCOMPARE(bench.sentences.size(), 1);
    QVERIFY(bench.sentences.first().contains(QStringLiteral("newer version")));
}

void TestArchiveWriter::answersInAnotherThread()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.read(1, noon + 1s, 256);
    bench.writer->appendJournal({JournalKind::Info, noon + 1s, QStringLiteral("x"), 0, 0});
    bench.writer->flush();
    ArchiveReader reader(bench.config);
    const SeriesQuery query{{tiltX, tiltY}, noon, noon + 1h, 0};
    auto series = reader.source()(query);
    auto forgotten = reader.series(query);
    forgotten.cancel();
    auto events = reader.events(noon, noon + 1h, 5);
    series.waitForFinished();
    QCOMPARE(series.result().size(), 2);
    QCOMPARE(series.result().at(1).buckets, (Buckets{{noon + 1s, -1, -1, -1, 1, 1}}));
    QCOMPARE(events.result().size(), 1);
    QCOMPARE(reader.gaps({1}, noon, noon + 1h).result(), QList<Gap>());
    QCOMPARE(reader.blocks(3, noon, noon + 1h).result(), QList<SampleBlock>());
    bench.read(1, noon + 2s, 512);
    bench.writer->flush();
    QCOMPARE(reader.series(query).result().at(0).buckets.size(), 2);
}

void TestArchiveWriter::answersOfNoArchiveAreEmpty()
{
    ArchiveReader reader(archiveConfig(file()));
    QCOMPARE(reader.series({{tiltX}, noon, noon + 1h, 100}).result().value(0).buckets, Buckets());
    QCOMPARE(reader.events(noon, noon + 1h, 5).result(), QList<JournalEntry>());
    QVERIFY(!QFile::exists(file()));
}

void TestArchiveWriter::choosesTheCoarsestStep_data()
{
    QTest::addColumn<qint64>("hours");
    QTest::addColumn<int>("width");
    QTest::addColumn<qint64>("seconds");
    QTest::newRow("10 years") << qint64{87600} << 1500 << qint64{86400};
    QTest::newRow("a year") << qint64{8760} << 1500 << qint64{4 * 3600};
    QTest::newRow("a month") << qint64{720} << 1500 << qint64{20 * 60};
    QTest::newRow("a day") << qint64{24} << 1440 << qint64{60};
    QTest::newRow("a little more") << qint64{24} << 1441 << qint64{30};
    QTest::newRow("an hour") << qint64{1} << 1500 << qint64{0};
    QTest::newRow("everything") << qint64{8760} << 0 << qint64{0};
}

void TestArchiveWriter::choosesTheCoarsestStep()
{
    QFETCH(qint64, hours);
    QFETCH(int, width);
    QFETCH(qint64, seconds);
    const SeriesStep step = stepFor(std::chrono::hours(hours), width);
    QCOMPARE(step.step, std::chrono::microseconds(std::chrono::seconds(seconds)));
    const bool isRollup = seconds >= 60;
    QCOMPARE(step.kind != ChunkKind::FullRate, isRollup);
}

QTEST_GUILESS_MAIN(TestArchiveWriter)

#include "tst_archivewriter.moc"
