#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};
const QString memory = QStringLiteral("memory of 12345678");

/// Both channels, \a minutes after noon.
QList<DeviceRecord> recordsAt(const QList<int> &minutes)
{
    QList<DeviceRecord> records;
    for (const int minute : minutes) {
        for (const char *axis : {"X", "Y"}) {
            records.append(
                {1, noon + minute * 1min, QStringLiteral("%1 %2").arg(QLatin1String(axis)).arg(minute),
                 QByteArray::number(minute)});
        }
    }
    return records;
}

Gap stopped(std::chrono::minutes from, std::chrono::minutes to, const QString &source = {})
{
    return {1, noon + from, noon + to, GapReason::ProgramStopped, source};
}

} // namespace

/// What sensors kept themselves comes late to an archive that was away from noon to ten in the evening.
class TestBackfill : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void fillsWhatRecordsCover();
    void theSameAgainChangesNothing();
    void newOnesContinueOldOnes();
    void leavesTheTimeOfReadingsAlone();
    void curvesShowReadings();
    void anUnknownSensorBecomesKnown();
    void aGapThatGoesOnStaysFilled_data();
    void aGapThatGoesOnStaysFilled();
    void aKillLeavesNothingHalf();
    void aWrongClockFillsNothing();

private:
    QString file() const { return m_folder->filePath(QStringLiteral("archive.sqlite")); }
    QList<Gap> gaps() { return ArchiveQuery(m_bench->config).gaps({1}, noon - 24h, noon + 48h); }
    qsizetype countRecords() { return ArchiveQuery(m_bench->config).records(1, noon - 24h, noon + 48h).size(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ArchiveBench> m_bench;
};

void TestBackfill::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_bench = std::make_unique<ArchiveBench>(archiveConfig(file()));
    m_bench->open(noon);
    m_bench->read(1, noon, 5);
    m_bench->close();
    m_bench->open(noon + 10h);
    m_bench->read(1, noon + 10h, 6);
    m_bench->writer->flush();
    QCOMPARE(gaps(), QList<Gap>{stopped(0h, 10h)});
}

void TestBackfill::fillsWhatRecordsCover()
{
    m_bench->writer->appendRecords({1, memory, recordsAt({30, 90, 150, 330}), {}});
    m_bench->writer->flush();
    const QList<Gap> expected{
        stopped(0min, 210min, memory), stopped(210min, 330min), stopped(330min, 390min, memory),
        stopped(390min, 600min)};
    QCOMPARE(gaps(), expected);
    QCOMPARE(countRecords(), 8);
    const QDate day(2024, 12, 31);
    ArchiveQuery query(m_bench->config);
    QCOMPARE(
        query.completeness({1}, day, day, QTimeZone::utc()),
        (QList<DayCompleteness>{{1, day, 210min + 60min, 600min}}));
    QCOMPARE(
        m_bench->ask(tiltX, noon, noon + 10h, 0).gaps,
        (QList<TimeSpan>{{noon + 210min, noon + 330min}, {noon + 390min, noon + 600min}}));
}

void TestBackfill::theSameAgainChangesNothing()
{
    const QList<Reading> readings{tiltReading(1, noon + 90min, 7), tiltReading(1, noon + 150min, 8)};
    m_bench->writer->appendRecords({1, memory, recordsAt({90, 150}), readings});
    m_bench->writer->flush();
    const QList<Gap> before = gaps();
    QCOMPARE(before.size(), 2);
    for (int round = 0; round < 3; ++round) {
        m_bench->writer->appendRecords({1, QStringLiteral("again"), recordsAt({90, 150}), readings});
        m_bench->close();
        m_bench->open(noon + 10h);
        m_bench->read(1, noon + 10h + 1s, 6);
        QCOMPARE(gaps(), before);
        QCOMPARE(countRecords(), 4);
        QCOMPARE(m_bench->fullRate(tiltX, noon + 1min, noon + 9h).size(), 2);
    }
}

/// A recorder is asked for the new ones only, each time.
void TestBackfill::newOnesContinueOldOnes()
{
    for (const int minute : {60, 120, 180, 240, 420}) {
        m_bench->writer->appendRecords(
            {1, memory, recordsAt({minute}), {tiltReading(1, noon + minute * 1min, minute)}});
        m_bench->writer->flush();
    }
    const QList<Gap> all = gaps();
    QCOMPARE(all.size(), 5); // the first stood for a second as long as it was alone
    QCOMPARE(all.at(1), stopped(60min, 300min, memory));
    QCOMPARE(all.at(2), stopped(300min, 420min));
    QCOMPARE(m_bench->fullRate(tiltX, noon + 1min, noon + 9h).size(), 5);
}

void TestBackfill::leavesTheTimeOfReadingsAlone()
{
    const QList<Gap> before = gaps();
    const QList<int> minutes{-10, 0, 600};
    QList<Reading> readings;
    for (const int minute : minutes.sliced(1)) {
        readings.append(tiltReading(1, noon + minute * 1min, 100));
    }
    m_bench->now = noon + 11h;
    m_bench->writer->appendRecords({1, memory, recordsAt({0, 600}), readings});
    m_bench->writer->flush();
    QCOMPARE(gaps().first(), before.first());
    QCOMPARE(countRecords(), 4);
    const Buckets all = m_bench->fullRate(tiltX, noon, noon + 11h);
    QCOMPARE(all.size(), 2);
    QCOMPARE(all.at(1).mean, 6 / 256.0);
}

void TestBackfill::curvesShowReadings()
{
    QList<Reading> readings;
    for (const int minute : {105, 90, 120, 135}) { // in any order
        readings.append(tiltReading(1, noon + minute * 1min, minute));
    }
    m_bench->writer->appendRecords({1, memory, recordsAt({90, 105, 120, 135}), readings});
    m_bench->writer->flush();
    const Buckets full = m_bench->fullRate(tiltX, noon + 1min, noon + 9h);
    QCOMPARE(full.size(), 4);
    QCOMPARE(full.at(1), (SeriesBucket{noon + 105min, 105 / 256.0, 105 / 256.0, 105 / 256.0, 1, 1}));
    const Buckets hours = m_bench->ask(tiltX, noon, noon + 10h, 10).buckets;
    QCOMPARE(hours.size(), 3); // noon, 13:00, 14:00
    QCOMPARE(hours.at(1), (SeriesBucket{noon + 60min, 90 / 256.0, 97.5 / 256, 105 / 256.0, 2, 2}));
    const Buckets days = m_bench->ask(tiltX, noon - 12h, noon + 36h, 2).buckets;
    QCOMPARE(days.at(0).count, 6U);
    QCOMPARE(days.at(0).maximum, 135 / 256.0);
    const QList<Gap> expected{stopped(0min, 90min), stopped(90min, 150min, memory), stopped(150min, 600min)};
    QCOMPARE(gaps(), expected);
}

/// From the first record on it is known; what no record covers is a gap.
void TestBackfill::anUnknownSensorBecomesKnown()
{
    QList<Reading> readings;
    for (int hour = 0; hour < 5; ++hour) {
        readings.append(tiltReading(2, noon - 24h + hour * 1h, hour));
    }
    m_bench->writer->appendRecords({2, memory, {}, readings});
    m_bench->writer->flush();
    ArchiveQuery query(m_bench->config);
    const QList<Gap> expected{
        {2, noon - 24h, noon - 19h, GapReason::ProgramStopped, memory},
        {2, noon - 19h, noon + 10h, GapReason::ProgramStopped, {}}};
    QCOMPARE(query.gaps({2}, noon - 48h, noon + 10h), expected);
    const QDate day(2024, 12, 30);
    QCOMPARE(
        query.completeness({2}, day.addDays(-5), day, QTimeZone::utc()), (QList<DayCompleteness>{{2, day, 5h, 12h}}));
    QCOMPARE(m_bench->fullRate({2, Quantity::Temperature}, noon - 48h, noon).size(), 5);
}

void TestBackfill::aGapThatGoesOnStaysFilled_data()
{
    QTest::addColumn<bool>("isKilled");
    QTest::newRow("it ends") << false;
    QTest::newRow("the program is killed") << true;
}

/// The records are read while the sensor is silent, and the ledger tells the end of that gap later.
void TestBackfill::aGapThatGoesOnStaysFilled()
{
    QFETCH(bool, isKilled);
    const UtcTime silent = noon + 10h;
    for (int second = 1; second <= 100; ++second) {
        m_bench->now = silent + second * 1s;
        m_bench->writer->flush();
    }
    QCOMPARE(gaps().last(), (Gap{1, silent, {}, GapReason::NoAnswer, {}}));
    m_bench->writer->appendRecords(
        {1, memory, {{1, silent + 30s, QStringLiteral("X"), "1"}, {1, silent + 60s, QStringLiteral("X"), "2"}}, {}});
    m_bench->writer->flush();
    QCOMPARE(gaps().last(), (Gap{1, silent + 90s, {}, GapReason::NoAnswer, {}}));
    QList<Gap> expected{
        stopped(0h, 10h),
        {1, silent, silent + 90s, GapReason::NoAnswer, memory},
        {1, silent + 90s, silent + 101s, GapReason::NoAnswer, {}}};
    if (isKilled) {
        m_bench->writer.reset();
        m_bench->open(silent + 101s);
        expected.last().to = silent + 100s;
        expected.append({1, silent + 100s, silent + 101s, GapReason::ProgramStopped, {}});
    }
    m_bench->read(1, silent + 101s, 9);
    m_bench->close();
    expected.removeIf([](const Gap &gap) { return *gap.to - gap.from < 3s; });
    QCOMPARE(gaps(), expected);
}

void TestBackfill::aKillLeavesNothingHalf()
{
    const QList<Gap> before = gaps();
    m_bench->writer->appendRecords({1, memory, recordsAt({90, 150}), {tiltReading(1, noon + 90min, 7)}});
    m_bench->writer.reset();
    QCOMPARE(gaps(), before);
    QCOMPARE(countRecords(), 0);
    QCOMPARE(m_bench->fullRate(tiltX, noon + 1min, noon + 9h).size(), 0);
}

void TestBackfill::aWrongClockFillsNothing()
{
    const QList<Gap> before = gaps();
    m_bench->writer->appendRecords({1, memory, recordsAt({6000, 6060}), {tiltReading(1, noon + 100h, 7)}});
    m_bench->writer->appendRecords({77, memory, recordsAt({60}), {}}); // there is no such sensor
    m_bench->writer->flush();
    QCOMPARE(gaps(), before);
    QCOMPARE(m_bench->fullRate(tiltX, noon, noon + 200h).size(), 2);
    QCOMPARE(ArchiveQuery(m_bench->config).records(1, noon, noon + 200h).size(), 4);
    QCOMPARE(ArchiveQuery(m_bench->config).records(77, noon, noon + 200h).size(), 0);
}

QTEST_GUILESS_MAIN(TestBackfill)

#include "tst_backfill.moc"
