#include "app/tool/historyimport.h"
#include "tests/core/archive/archivesite.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QTest>

#include <cmath>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using tool::HistoryImport;
using tool::ImportReport;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};
const UtcTime newYear = noon + 9h; ///< there
const UtcTime later = noon + 48h;

// Two groups: N 1, N 2. The clock on the wall is three hours ahead.
const QByteArray december = "23:59:57 31.12.24\t3300\t  -264.0\t -6644.6\t\t     0.0\t 0 0000 0000 0000\t    10.5\t   "
                            "-20.5\t 21.25\t     0.0\t 0 "
                            "0000 0000 0000\r\n"
                            "23:59:58 31.12.24\t3300\t  -263.0\t -6644.7\t\t     0.0\t 0 0000 0000 0000\t    10.6\t   "
                            "-20.6\t 21.25\t     0.0\t 0 "
                            "0000 0000 0000\r\n"
                            "23:59:59 31.12.24\t3300\t  -265.0\t -6644.8\t\t     0.0\t 0 0000 0000 0000\t        \t    "
                            "    \t      \t        \t 1 "
                            "0000 0000 0000\r\n";
const QByteArray january = "00:00:00 01.01.25\t3300\t     1.5\t     7.0\t\t     0.0\t 0 0000 0000 0000\t    10.8\t   "
                           "-20.8\t 21.50\t     0.0\t 0 "
                           "0000 0000 0000\r\n"
                           "somebody typed this\r\n"
                           "00:00:01 01.01.25\t3300\t     2.5\t     8.0\t\t     0.0\t 0 0000 0000 0000\t    10.9\t   "
                           "-20.9\t 21.50\t     0.0\t 0 "
                           "0000 0000 0000\r\n"
                           "00:00:02 01.01.25\t3300\t     3.";
// Two groups: N 2, N 3.
const QByteArray accelerations = "23:59:58 31.12.24\t3300\t   3.000\t   4.000\t   1.500\t   2.000\t 0 0000 0000 0000\t "
                                 "  0.300\t   0.400\t   0.150\t   "
                                 "0.200\t 0 0000 0000 0000\r\n";

/// What one sensor says in a file of two, \a second after noon.
QByteArray line(int second, const QByteArray &x)
{
    const QByteArray group = "\t  " + x + "\t     0.0\t\t     0.0\t 0 0000 0000 0000";
    return "15:00:" + QByteArray::number(second).rightJustified(2, '0') + " 31.12.24\t3300" + group + group + "\r\n";
}

} // namespace

/// Files of the History folder that go into an archive afterwards.
class TestHistoryImport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void fillsAnEmptyArchive();
    void queriesGoOverTheYear();
    void aSecondRunAddsNothing();
    void bothFilesOfAMonthAreOne();
    void onlyGapsAreFilled();
    void halfAFileIsContinued();
    void damagedLinesAreNamed();
    void samplesComeOnce();
    void refusesOtherFolders();
    void refusesWhileAProgramWrites();

private:
    void put(const QString &name, const QByteArray &bytes) const { writeAll(m_folder->filePath(name), bytes); }
    ImportReport import();
    QList<Gap> gaps(int number) const { return ArchiveQuery(m_config).gaps({number}, noon - 48h, noon + 96h); }

    std::unique_ptr<QTemporaryDir> m_folder;
    ArchiveConfig m_config;
};

void TestHistoryImport::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("Bin")));
    m_config = archiveConfig(m_folder->filePath(QStringLiteral("archive.sqlite")));
    m_config.lines[0].sensors[1].measuresAcceleration = true;
}

ImportReport TestHistoryImport::import()
{
    const HistoryFolder folder{m_folder->path(), m_config.lines.first().sensors, moscowZone()};
    return HistoryImport(folder, m_config, [](const QString &, int) {}).run(later);
}

void TestHistoryImport::fillsAnEmptyArchive()
{
    put(QStringLiteral("2024_12_data.txt"), december);
    put(QStringLiteral("2025_01_data.txt"), january);
    const ImportReport report = import();
    QCOMPARE(report.failure, QString());
    QCOMPARE(report.files, 2);
    QCOMPARE(report.records, 5);
    QCOMPARE(report.added, 5 + 4); // of N 2 one is not valid
    const QString first = QStringLiteral("2024_12_data.txt");
    const QString second = QStringLiteral("2025_01_data.txt");
    const QList<Gap> expected{
        {1, newYear - 3s, newYear, GapReason::ProgramStopped, first},
        {1, newYear, newYear + 2s, GapReason::ProgramStopped, second},
        {1, newYear + 2s, later, GapReason::ProgramStopped, {}}};
    QCOMPARE(gaps(1), expected);
    const QDate day(2024, 12, 31);
    QCOMPARE(
        ArchiveQuery(m_config).completeness({1}, day, day, moscowZone()), (QList<DayCompleteness>{{1, day, 3s, 3s}}));
}

void TestHistoryImport::queriesGoOverTheYear()
{
    put(QStringLiteral("2024_12_data.txt"), december);
    put(QStringLiteral("2025_01_data.txt"), january);
    import();
    ArchiveBench bench(m_config);
    const QList<double> values{-264, -263, -265, 1.5, 2.5};
    const Buckets full = bench.fullRate(tiltX, noon, later);
    QCOMPARE(full.size(), 5);
    for (int i = 0; i < 5; ++i) {
        const double value = values.at(i);
        QCOMPARE(full.at(i), (SeriesBucket{newYear - 3s + i * 1s, value, value, value, 1, 1}));
    }
    QCOMPARE(bench.fullRate({2, Quantity::Temperature}, noon, newYear).size(), 2);
    const Buckets minutes = bench.ask(tiltX, newYear - 60min, newYear + 60min, 120).buckets;
    QCOMPARE(minutes.size(), 2);
    QCOMPARE(minutes.at(0), (SeriesBucket{newYear - 1min, -265, -264, -263, 3, 3}));
    QCOMPARE(minutes.at(1), (SeriesBucket{newYear, 1.5, 2, 2.5, 2, 2}));
    const Buckets days = bench.ask(tiltX, noon - 12h, noon + 36h, 2).buckets;
    QCOMPARE(days.size(), 1);
    QCOMPARE(days.at(0).count, 5U);
    QCOMPARE(days.at(0).minimum, -265);
    QCOMPARE(days.at(0).maximum, 2.5);
}

void TestHistoryImport::aSecondRunAddsNothing()
{
    put(QStringLiteral("2024_12_data.txt"), december);
    put(QStringLiteral("2024_12_adata.txt"), accelerations);
    import();
    const QList<Gap> before = gaps(1);
    ArchiveBench bench(m_config);
    const Buckets full = bench.fullRate({2, Quantity::TiltX}, noon, later);
    for (int run = 0; run < 2; ++run) {
        const ImportReport report = import();
        QCOMPARE(report.failure, QString());
        QCOMPARE(report.added, 0);
        QCOMPARE(gaps(1), before);
        QCOMPARE(bench.fullRate({2, Quantity::TiltX}, noon, later), full);
        QCOMPARE(bench.ask(tiltX, noon - 12h, noon + 36h, 2).buckets.at(0).count, 3U);
    }
}

/// N 2 has columns in both: tilt in the one, accelerations in the other.
void TestHistoryImport::bothFilesOfAMonthAreOne()
{
    put(QStringLiteral("2024_12_data.txt"), december);
    put(QStringLiteral("2024_12_adata.txt"), accelerations);
    QCOMPARE(import().added, 3 + 2 + 1);
    ArchiveBench bench(m_config);
    QCOMPARE(bench.fullRate({2, Quantity::TiltX}, noon, later).size(), 2);
    const Buckets maximum = bench.fullRate({2, Quantity::AccelMaximum}, noon, later);
    QCOMPARE(maximum, (Buckets{{newYear - 2s, 5, 5, 5, 1, 1}}));
    QCOMPARE(bench.fullRate({3, Quantity::AccelRmsY}, noon, later).value(0).mean, 0.2);
}

void TestHistoryImport::onlyGapsAreFilled()
{
    ArchiveBench bench(m_config);
    bench.open(noon);
    for (int second = 0; second <= 5; ++second) {
        bench.read(1, noon + second * 1s, 256);
    }
    bench.close();
    bench.open(noon + 20s);
    for (int second = 20; second <= 25; ++second) {
        bench.read(1, noon + second * 1s, 256);
    }
    bench.close();
    QByteArray text;
    for (const int second : {4, 5, 6, 7, 8, 15, 16, 21}) {
        text += line(second, QByteArray::number(second) + ".0");
    }
    put(QStringLiteral("2024_12_data.txt"), text);
    const ImportReport report = import();
    QCOMPARE(report.added, 5 + 8); // of N 2 nothing was known
    const QString source = QStringLiteral("2024_12_data.txt");
    const QList<Gap> expected{
        {1, noon + 5s, noon + 9s, GapReason::ProgramStopped, source},
        {1, noon + 9s, noon + 15s, GapReason::ProgramStopped, {}},
        {1, noon + 15s, noon + 17s, GapReason::ProgramStopped, source},
        {1, noon + 17s, noon + 20s, GapReason::ProgramStopped, {}},
        {1, noon + 25s, later, GapReason::ProgramStopped, {}}};
    QCOMPARE(gaps(1), expected);
    QList<double> values;
    for (const SeriesBucket &bucket : bench.fullRate(tiltX, noon, noon + 1h)) {
        values.append(bucket.mean);
    }
    QCOMPARE(values, (QList<double>{1, 1, 1, 1, 1, 1, 6, 7, 8, 15, 16, 1, 1, 1, 1, 1, 1}));
    const SeriesBucket minute = bench.ask(tiltX, noon - 1h, noon + 1h, 120).buckets.value(0);
    QCOMPARE(minute.count, 17U);
    QCOMPARE(minute.maximum, 16);
    QVERIFY(std::abs(minute.mean - (12 + 6 + 7 + 8 + 15 + 16) / 17.0) < 1.0 / 16); // a mean is kept in such parts
    QCOMPARE(import().added, 0);
}

/// The program that writes the files was in the middle of a line when they were copied.
void TestHistoryImport::halfAFileIsContinued()
{
    QByteArray text;
    for (int second = 0; second < 60; ++second) {
        text += line(second, QByteArray::number(second) + ".5");
    }
    const QString name = QStringLiteral("2024_12_data.txt");
    put(name, text.first(text.size() / 2 + 20));
    const ImportReport half = import();
    QCOMPARE(half.records, 30);
    QCOMPARE(half.damaged, 1);
    QCOMPARE(half.added, 60);
    put(name, text);
    QCOMPARE(import().added, 60);
    ArchiveBench bench(m_config);
    const Buckets all = bench.fullRate(tiltX, noon, noon + 1h);
    QCOMPARE(all.size(), 60);
    QCOMPARE(all.at(47).mean, 47.5);
    QCOMPARE(gaps(1).first(), (Gap{1, noon, noon + 60s, GapReason::ProgramStopped, name}));
}

void TestHistoryImport::damagedLinesAreNamed()
{
    put(QStringLiteral("2025_01_data.txt"), january);
    put(QStringLiteral("2024_11_data.txt"), {});
    const ImportReport report = import();
    QCOMPARE(report.damaged, 2);
    const QStringList expected{
        QStringLiteral("2024_11_data.txt holds no records and is left out."),
        QStringLiteral("2025_01_data.txt: damaged lines, 2 in all, are left out: 2, 4.")};
    QCOMPARE(report.complaints, expected);
}

void TestHistoryImport::samplesComeOnce()
{
    ArchiveBench bench(m_config);
    bench.open(noon);
    bench.writer->appendBlock(sampleBlock(noon + 10s, 0, 100));
    bench.now = noon + 30s;
    bench.close();
    QByteArray raw;
    for (int i = 0; i < 300; ++i) { // 15:00:00…15:00:30
        raw.append(static_cast<char>(i % 100)).append('\0');
    }
    put(QStringLiteral("Bin/24_12_31_15_00_00_3X.wrd"), raw);
    put(QStringLiteral("Bin/24_12_31_15_00_00_3Y.wrd"), raw);
    const ImportReport report = import();
    QCOMPARE(report.failure, QString());
    QCOMPARE(report.added, 200);
    QCOMPARE(import().added, 0);
    const QList<SampleBlock> blocks = ArchiveQuery(m_config).blocks(3, noon, noon + 1h);
    qsizetype count = 0;
    for (const SampleBlock &block : blocks) {
        count += block.x.size();
    }
    QCOMPARE(count, 300);
    QVERIFY(blocks.first().start == noon);
    QCOMPARE(blocks.first().x.at(7), 7);
    QCOMPARE(bench.fullRate({3, Quantity::SampleX}, noon, noon + 1h).size(), 300);
}

void TestHistoryImport::refusesOtherFolders()
{
    QVERIFY(import().failure.startsWith(QStringLiteral("There are no old records in ")));
    put(QStringLiteral("2024_12_data.txt"), "23:59:57 31.12.24\t3300\t  1.0\t 2.0\t\t     0.0\t 0 0000 0000 0000\r\n");
    const ImportReport report = import();
    QVERIFY(report.failure.contains(QStringLiteral("is of this configuration")));
    QCOMPARE(report.foreign, 1);
    QVERIFY(report.complaints.first().startsWith(
        QStringLiteral("2024_12_data.txt holds 1 sensors and the configuration has 2")));
    QVERIFY(!QFile::exists(m_config.file));
}

void TestHistoryImport::refusesWhileAProgramWrites()
{
    put(QStringLiteral("2024_12_data.txt"), december);
    ArchiveBench bench(m_config);
    bench.open(noon);
    QVERIFY(import().failure.startsWith(QStringLiteral("Another copy of the program writes into ")));
    bench.close();
    QCOMPARE(bench.fullRate(tiltX, noon, later).size(), 0);
    QCOMPARE(import().failure, QString());
}

QTEST_GUILESS_MAIN(TestHistoryImport)

#include "tst_historyimport.moc"
