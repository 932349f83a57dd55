#include "app/tool/exportcommand.h"
#include "app/tool/exportoptions.h"
#include "tests/core/export/keptsite.h"

#include <QCommandLineParser>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>

using namespace gorizont;
using namespace gorizont::tool;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using test::utc;

namespace {

ExportSite site()
{
    return {
        {test::accelerometer(1, {}), test::inclinometer(2, {}), test::inclinometer(7, {})},
        u"Мост"_s,
        QTimeZone(3 * 3600)};
}

std::variant<ExportRequest, QString> parse(const QString &line)
{
    QCommandLineParser parser;
    describeExport(parser);
    const QStringList arguments = line.split(u' ', Qt::SkipEmptyParts);
    return parser.parse(QStringList{u"gorizont-tool export"_s} + arguments) ? exportRequest(parser, site())
                                                                            : parser.errorText();
}

QList<int> numbers(const ExportRequest &request)
{
    QList<int> list;
    for (const SensorConfig &sensor : request.sensors) {
        list << sensor.number;
    }
    return list;
}

} // namespace

/// `gorizont-tool export`: what the command line means, and how it ends.
class TestExportCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void defaults()
    {
        const auto request = std::get<ExportRequest>(parse(u"--from 2018-02-07 --to 2018-02-08 --out a.csv"_s));
        QCOMPARE(request.format, ExportFormat::CsvRussian);
        QCOMPARE(request.every, ExportEvery::Reading);
        QCOMPARE(numbers(request), QList<int>({1, 2, 7}));
        QCOMPARE(request.quantities, readingQuantities());
        QCOMPARE(request.from, utc("2018-02-06T21:00:00.000Z"));
        QCOMPARE(request.to, utc("2018-02-08T21:00:00.000Z")); // the end of the day
        QCOMPARE(request.seed, (SeedCodes{u"XX"_s, u"MOST"_s, u"BN1"_s, u"BN2"_s}));
        QCOMPARE(request.path, u"a.csv"_s);
    }

    void everything()
    {
        const auto request = std::get<ExportRequest>(
            parse(u"--from 2018-02-07T18:33:03.250 --to 2018-02-07T16:00:00Z --sensors 7,1-2,2 --quantities "
                  "sample-x,tilt-y --format mseed --every hour --out b.mseed --network gs --station abc --channels "
                  "bnx,bny"_s));
        QCOMPARE(request.format, ExportFormat::MiniSeed);
        QCOMPARE(request.every, ExportEvery::Hour);
        QCOMPARE(numbers(request), QList<int>({7, 1, 2}));
        QCOMPARE(request.quantities, QList<Quantity>({Quantity::SampleX, Quantity::TiltY}));
        QCOMPARE(request.from, utc("2018-02-07T15:33:03.250Z"));
        QCOMPARE(request.to, utc("2018-02-07T16:00:00.000Z"));
        QCOMPARE(request.seed, (SeedCodes{u"GS"_s, u"ABC"_s, u"BNX"_s, u"BNY"_s}));
    }

    void mistakes_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("problem");
        const QString good = u"--from 2018-02-07 --to 2018-02-08 --out a.csv "_s;
        QTest::newRow("from") << u"--to 2018-02-08 --out a"_s << u"--from is missing"_s;
        QTest::newRow("out") << u"--from 2018-02-07 --to 2018-02-08"_s << u"--out is missing"_s;
        QTest::newRow("time") << u"--from 7.2.18 --to 2018-02-08 --out a"_s
                              << u"--from takes a day (2018-02-07) or a moment (2018-02-07T18:33:03), not \"7.2.18\""_s;
        QTest::newRow("format") << good + u"--format xls"_s << u"--format takes csv-ru, csv-iso, mseed, not \"xls\""_s;
        QTest::newRow("every") << good + u"--every week"_s << u"--every takes raw, minute, hour, day, not \"week\""_s;
        QTest::newRow("sensors") << good + u"--sensors 1;2"_s
                                 << u"--sensors takes numbers and ranges of them (1,3,5-8), or all, not \"1;2\""_s;
        QTest::newRow("no sensor") << good + u"--sensors 1,3-6"_s << u"the site has no sensor 3"_s;
        QTest::newRow("channels") << good + u"--channels BN1"_s << u"--channels takes BN1,BN2, not \"BN1\""_s;
        QTest::newRow("words") << good + u"more"_s << u"after export comes nothing"_s;
        QTest::newRow("option") << good + u"--device COM1"_s << u"Unknown option 'device'."_s;
    }
    void mistakes()
    {
        QFETCH(QString, line);
        QFETCH(QString, problem);
        QCOMPARE(std::get<QString>(parse(line)), problem);
    }

    void quantitiesAreListed()
    {
        const QString problem = std::get<QString>(parse(u"--from 2018-02-07 --to 2018-02-08 --out a --quantities x"_s));
        QVERIFY(problem.startsWith(u"--quantities takes tilt-x, tilt-y, temperature, heater, fan, accel-max,"_s));
        QVERIFY(problem.endsWith(u"sample-x, sample-y, all, not \"x\""_s));
    }

    void exitCodes()
    {
        const QTemporaryDir folder;
        auto request = std::get<ExportRequest>(
            parse(u"--from 2018-02-07 --to 2018-02-07 --out %1"_s.arg(folder.filePath(u"a.csv"_s))));
        test::KeptSite kept;
        QCOMPARE(exportHistory(request, kept.source(), true), ExitNoAnswer); // nothing in the range
        kept.series = {{{2, Quantity::TiltX}, {}, {test::reading(request.from + 1h, 5)}, {}}};
        QCOMPARE(exportHistory(request, kept.source(), true), ExitGood);
        QVERIFY(test::contentOf(request.path).contains("\r\n07.02.2018 01:00:00,000;"));
    }

    /// Ctrl+C while the archive is silent.
    void interrupted()
    {
        const QTemporaryDir folder;
        const auto request = std::get<ExportRequest>(
            parse(u"--from 2018-02-07 --to 2018-02-07 --out %1"_s.arg(folder.filePath(u"a.csv"_s))));
        QPromise<QList<Series>> never;
        never.start();
        ArchiveSource silent;
        silent.series = [&never](const SeriesQuery &) {
            std::raise(SIGINT);
            return never.future();
        };
        QCOMPARE(exportHistory(request, silent, false), ExitRefused);
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestExportCommand)
#include "tst_exportcommand.moc"
