#include "core/export/exportrun.h"
#include "tests/core/export/keptsite.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;
using test::noReading;
using test::reading;
using test::utc;

namespace {

const QTimeZone moscow(3 * 3600);

/// Two sensors that answer at moments of their own, one of them on both sides of midnight in Moscow.
test::KeptSite readings()
{
    const UtcTime start = utc("2018-02-07T15:33:03.250Z");
    test::KeptSite site;
    site.series = {
        {{1, Quantity::TiltX},
         {},
         {reading(start, -264), reading(start + 1000999us, -0.0004), reading(utc("2018-02-07T20:59:59.999Z"), 12.3456),
          reading(utc("2018-02-07T21:00:00.000Z"), 1234567.125)},
         {}},
        {{1, Quantity::Temperature},
         {},
         {reading(start, 21.384), noReading(start + 1000999us), noReading(utc("2018-02-07T21:00:01.000Z"))},
         {}},
        {{2, Quantity::TiltX}, {}, {reading(start + 500ms, -3599.5), reading(start + 1000999us, 0.0624)}, {}}};
    return site;
}

/// Hours of one sensor around the same midnight.
test::KeptSite hours()
{
    const UtcTime midnight = utc("2018-02-07T21:00:00.000Z");
    test::KeptSite site;
    site.series = {
        {{1, Quantity::TiltX},
         1h,
         {{midnight - 1h, -2, 0.5, 3, 3600, 3600},
          {midnight, -3, 1, 5, 3600, 3600},
          {midnight + 1h, 0, 0, 0, 3600, 0},
          {midnight + 2h, -1, 2, 9, 3600, 1200}},
         {}}};
    return site;
}

ExportRequest request(ExportFormat format, ExportEvery every, const QString &path)
{
    ExportRequest request;
    request.format = format;
    request.every = every;
    request.sensors = {test::accelerometer(1, QStringLiteral("Этаж 2, ось \"А\"; север")), test::inclinometer(2, {})};
    request.quantities = {Quantity::TiltX, Quantity::Temperature};
    request.from = utc("2018-02-07T15:00:00.000Z");
    request.to = utc("2018-02-08T06:00:00.000Z");
    request.zone = moscow;
    request.path = path;
    return request;
}

} // namespace

/// Tables of values against files that were written by hand.
class TestTableExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void tables_data()
    {
        QTest::addColumn<QString>("expected");
        QTest::addColumn<ExportFormat>("format");
        QTest::addColumn<ExportEvery>("every");
        QTest::addColumn<quint64>("rows");
        QTest::newRow("ru") << "readings-ru.csv" << ExportFormat::CsvRussian << ExportEvery::Reading << quint64(5);
        QTest::newRow("iso") << "readings-iso.csv" << ExportFormat::CsvIso << ExportEvery::Reading << quint64(5);
        QTest::newRow("minutes") << "minutes-iso.csv" << ExportFormat::CsvIso << ExportEvery::Minute << quint64(3);
        QTest::newRow("hours") << "hours-ru.csv" << ExportFormat::CsvRussian << ExportEvery::Hour << quint64(3);
        QTest::newRow("days") << "days-ru.csv" << ExportFormat::CsvRussian << ExportEvery::Day << quint64(2);
    }
    void tables()
    {
        QFETCH(QString, expected);
        QFETCH(ExportFormat, format);
        QFETCH(ExportEvery, every);
        QFETCH(quint64, rows);
        const bool isOfReadings = every == ExportEvery::Reading || every == ExportEvery::Minute;
        const test::KeptSite site = isOfReadings ? readings() : hours();
        const QString path = m_folder->filePath(expected);
        ExportWatch watch;
        const ExportResult result = runExport(request(format, every, path), site.source(), watch);
        QCOMPARE(result.failure, QString());
        QCOMPARE(result.rows, rows);
        QCOMPARE(result.files, QStringList(path));
        QCOMPARE(test::contentOf(path), test::contentOf(QStringLiteral(GORIZONT_TEST_DATA "/export/") + expected));
    }

    /// A day of the ISO table is one of UTC only if that is the zone asked for.
    void dayOfAnotherZone()
    {
        ExportRequest wanted =
            request(ExportFormat::CsvIso, ExportEvery::Day, m_folder->filePath(QStringLiteral("utc.csv")));
        wanted.zone = QTimeZone::utc();
        wanted.sensors = {test::inclinometer(1, {})};
        ExportWatch watch;
        QCOMPARE(runExport(wanted, hours().source(), watch).rows, quint64(1));
        QCOMPARE(
            test::contentOf(wanted.path),
            QByteArray("time,1 IN-D3 tilt-x (arcsec) min,1 IN-D3 tilt-x (arcsec) mean,1 IN-D3 tilt-x (arcsec) max\n"
                       "2018-02-07T00:00:00.000Z,-3.000,0.929,9.000\n"));
    }

    /// A year is asked for in pieces that follow each other, none of them longer than what fits in memory.
    void longRangesArePulledInPieces_data()
    {
        QTest::addColumn<ExportEvery>("every");
        QTest::addColumn<int>("longest");
        QTest::addColumn<int>("width"); // of the longest piece
        QTest::newRow("readings") << ExportEvery::Reading << 1 << 0;
        QTest::newRow("minutes") << ExportEvery::Minute << 24 << 24 * 60;
        QTest::newRow("hours") << ExportEvery::Hour << 31 * 24 << 31 * 24;
        QTest::newRow("days") << ExportEvery::Day << 366 * 24 << 366 * 24;
    }
    void longRangesArePulledInPieces()
    {
        QFETCH(ExportEvery, every);
        QFETCH(int, longest);
        QFETCH(int, width);
        QList<SeriesQuery> asked;
        test::KeptSite site = hours();
        site.asked = &asked;
        ExportRequest wanted = request(ExportFormat::CsvIso, every, m_folder->filePath(QStringLiteral("year.csv")));
        wanted.from = utc("2017-12-31T21:00:00.000Z");
        wanted.to = utc("2019-12-31T21:00:00.000Z");
        ExportWatch watch;
        int lastPercent = 0;
        watch.progress = [&](int percent, quint64) {
            QVERIFY(percent >= lastPercent);
            lastPercent = percent;
        };
        QCOMPARE(runExport(wanted, site.source(), watch).failure, QString());
        QCOMPARE(lastPercent, 100);
        QVERIFY(asked.size() > 1);
        QCOMPARE(asked.first().from, wanted.from);
        QCOMPARE(asked.last().to, wanted.to);
        for (qsizetype i = 0; i < asked.size(); ++i) {
            QVERIFY(asked.at(i).to - asked.at(i).from <= longest * 1h);
            QCOMPARE(asked.at(i).from, i == 0 ? wanted.from : asked.at(i - 1).to);
        }
        QCOMPARE(asked.first().width, width);
    }

    void refusals_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("range") << "range"
                               << "The range ends before it begins: set another beginning or end.";
        QTest::newRow("choice") << "choice"
                                << "None of the chosen sensors measures a chosen quantity: choose others.";
        QTest::newRow("nothing") << "nothing"
                                 << "There is nothing in this range, and no file was written: choose another range or "
                                    "other sensors.";
    }
    void refusals()
    {
        QFETCH(QString, what);
        QFETCH(QString, sentence);
        ExportRequest wanted =
            request(ExportFormat::CsvIso, ExportEvery::Reading, m_folder->filePath(QStringLiteral("no.csv")));
        if (what == u"range") {
            wanted.to = wanted.from;
        } else if (what == u"choice") {
            wanted.quantities = {Quantity::HeaterPower};
        } else {
            wanted.from = utc("2001-01-01T00:00:00.000Z");
            wanted.to = wanted.from + 3h;
        }
        ExportWatch watch;
        const ExportResult result = runExport(wanted, readings().source(), watch);
        QCOMPARE(result.failure, sentence);
        QCOMPARE(result.files, QStringList());
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestTableExport)
#include "tst_tableexport.moc"
