#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};

} // namespace

/// What the archive knows of the time in which it got nothing.
class TestArchiveGaps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void knowsThatItWasAway();
    void knowsThatItWasKilled();
    void tellsGapsOfSensors();
    void countsCompleteness();
    void acceptsClockSteps();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestArchiveGaps::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestArchiveGaps::knowsThatItWasAway()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.read(1, noon + 1s, 5);
    bench.close();
    bench.open(noon + 1h);
    bench.read(1, noon + 1h + 1s, 5);
    bench.close();
    ArchiveQuery query(bench.config);
    const QList<Gap> gaps = query.gaps({1}, noon, noon + 2h);
    QCOMPARE(gaps, (QList<Gap>{{1, noon + 1s, noon + 1h + 1s, GapReason::ProgramStopped, {}}}));
    QCOMPARE(bench.ask(tiltX, noon, noon + 2h, 0).gaps, (QList<TimeSpan>{{noon + 1s, noon + 1h + 1s}}));
}

/// A writer that is dropped without stop() is all that a kill leaves behind.
void TestArchiveGaps::knowsThatItWasKilled()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.read(1, noon + 1s, 5);
    bench.read(2, noon + 1s, 6);
    bench.writer->flush();
    for (int second = 2; second < 60; ++second) {
        bench.read(2, noon + second * 1s, 6);
        bench.writer->flush();
    }
    bench.writer.reset();
    ArchiveQuery before(bench.config);
    QVERIFY(!before.gaps({1}, noon, noon + 1h).value(0).to);
    bench.open(noon + 1h);
    bench.read(1, noon + 1h + 1s, 5);
    bench.read(2, noon + 1h + 1s, 5);
    bench.close();
    ArchiveQuery query(bench.config);
    const QList<Gap> expected{
        {1, noon + 1s, noon + 59s, GapReason::NoAnswer, {}},
        {1, noon + 59s, noon + 1h + 1s, GapReason::ProgramStopped, {}},
        {2, noon + 59s, noon + 1h + 1s, GapReason::ProgramStopped, {}}};
    QCOMPARE(query.gaps({1, 2}, noon, noon + 2h), expected);
}

void TestArchiveGaps::tellsGapsOfSensors()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    LineStatus lost;
    lost.port = 1;
    lost.state = LineState::Lost;
    bench.read(1, noon + 1s, 5);
    bench.writer->flush();
    bench.now = noon + 2s;
    bench.writer->updateLine(lost);
    for (int second = 2; second <= 60; ++second) {
        bench.now = noon + second * 1s;
        bench.writer->flush();
    }
    ArchiveQuery query(bench.config);
    QCOMPARE(query.gaps({1}, noon, noon + 2h), (QList<Gap>{{1, noon + 1s, {}, GapReason::PortError, {}}}));
    QCOMPARE(bench.ask(tiltX, noon, noon + 2h, 0).gaps, (QList<TimeSpan>{{noon + 1s, noon + 2h}}));
    bench.read(1, noon + 61s, 5);
    bench.close();
    QCOMPARE(query.gaps({1}, noon, noon + 2h), (QList<Gap>{{1, noon + 1s, noon + 61s, GapReason::PortError, {}}}));
}

void TestArchiveGaps::countsCompleteness()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    bench.read(1, noon, 5);
    bench.close();
    bench.open(noon + 3h);
    bench.read(1, noon + 3h, 5);
    bench.now = noon + 3h;
    bench.close();
    ArchiveQuery query(bench.config);
    const QDate day(2024, 12, 31);
    const auto days = query.completeness({1, 2}, day.addDays(-3), day.addDays(3), QTimeZone::utc());
    QCOMPARE(days, (QList<DayCompleteness>{{1, day, 0s, 3h}}));
}

void TestArchiveGaps::acceptsClockSteps()
{
    ArchiveBench bench(archiveConfig(file()));
    bench.open(noon);
    for (const auto offset : {0s, 3600s, 60s}) {
        for (int second = 1; second <= 40; ++second) {
            bench.read(1, noon + offset + second * 1s, second);
        }
        bench.writer->flush();
    }
    bench.close();
    const Buckets all = bench.fullRate(tiltX, noon, noon + 2h);
    QCOMPARE(all.size(), 120);
    QVERIFY(std::is_sorted(all.begin(), all.end(), [](const auto &a, const auto &b) { return a.from < b.from; }));
    QVERIFY(all.at(40).from == noon + 61s);
    quint32 count = 0;
    for (const SeriesBucket &bucket : bench.ask(tiltX, noon, noon + 2h, 120).buckets) {
        count += bucket.count;
    }
    QCOMPARE(count, 120U);
}

QTEST_GUILESS_MAIN(TestArchiveGaps)

#include "tst_archivegaps.moc"
