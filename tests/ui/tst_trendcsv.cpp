#include "ui/plots/trendcsv.h"
#include "ui/plots/trendlayouts.h"

#include "tests/ui/plotsource.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime start{1'518'017'583s}; ///< 2018-02-07 15:33:03 UTC

QList<CsvCurve> sample(ExportFormat format, bool isInDegrees)
{
    SensorConfig tower;
    tower.number = 1;
    tower.model = QStringLiteral("AN-D3");
    tower.place = QStringLiteral("\"Этаж\"; 2");
    SensorConfig cellar;
    cellar.number = 2;
    cellar.model = QStringLiteral("IN-D3");
    Series tilt;
    tilt.buckets = {
        test::reading(start - 1s, 1),
        test::reading(start, 3600),
        test::reading(start + 1500ms, -900),
        {start + 2s, 0, 0, 0, 1, 0},
        test::reading(start + 10s, 5)};
    Series mean;
    mean.step = 1min;
    mean.buckets = {{start, 20.5, 21, 22.25, 60, 60}};
    return {
        {csvColumn(tower, Quantity::TiltX, format, false, isInDegrees), tilt},
        {csvColumn(cellar, Quantity::Temperature, format, true, isInDegrees), mean}};
}

} // namespace

/// What a table of a trend looks like, and what a layout is kept as.
class TestTrendCsv : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void russianExcel()
    {
        const auto format = ExportFormat::CsvRussian;
        const QByteArray table = trendCsv(sample(format, true), {start, start + 10s}, format, QTimeZone(3 * 3600));
        QVERIFY(table.startsWith("\xEF\xBB\xBF"));
        QCOMPARE(
            QString::fromUtf8(table.mid(3)),
            QStringLiteral("Time;\"1 АН-Д3 [\"\"Этаж\"\"; 2] Tilt X, degrees\";2 ИН-Д3 Temperature, °C, min;"
                           "2 ИН-Д3 Temperature, °C, mean;2 ИН-Д3 Temperature, °C, max\r\n"
                           "07.02.2018 18:33:03,000;1,0000000;20,500;21,000;22,250\r\n"
                           "07.02.2018 18:33:04,500;-0,2500000;;;\r\n"));
    }

    /// As the export of the history: UTC, names that no language changes.
    void iso()
    {
        const auto format = ExportFormat::CsvIso;
        const QByteArray table = trendCsv(sample(format, false), {start, start + 10s}, format, QTimeZone(3 * 3600));
        QCOMPARE(
            QString::fromUtf8(table),
            QStringLiteral("time,\"1 AN-D3 [\"\"Этаж\"\"; 2] tilt-x (arcsec)\",2 IN-D3 temperature (degC) min,"
                           "2 IN-D3 temperature (degC) mean,2 IN-D3 temperature (degC) max\n"
                           "2018-02-07T15:33:03.000Z,3600.000,20.500,21.000,22.250\n"
                           "2018-02-07T15:33:04.500Z,-900.000,,,\n"));
        const QByteArray degrees = trendCsv(sample(format, true), {start, start + 1s}, format, QTimeZone(3 * 3600));
        QVERIFY(degrees.contains("tilt-x (deg)\","));
        QVERIFY(degrees.contains("03.000Z,1.0000000,20.500,"));
    }

    void nothingSeen()
    {
        QCOMPARE(trendCsv({}, {start, start + 1h}, ExportFormat::CsvIso, QTimeZone::utc()), QByteArray("time\n"));
    }

    void layouts()
    {
        QSettings settings(m_folder.filePath(QStringLiteral("a.ini")), QSettings::IniFormat);
        const QList<TrendLayout> kept{
            {QStringLiteral("Крыша / 1"), {{12, Quantity::TiltX}, {3, Quantity::AccelRms}}, 24h, TiltUnit::ArcSeconds},
            {QStringLiteral("2"), {}, 10min, TiltUnit::Degrees}};
        writeTrendLayouts(settings, QStringLiteral("a/b"), kept);
        QCOMPARE(readTrendLayouts(settings, QStringLiteral("a/b")), kept);
        writeTrendLayouts(settings, QStringLiteral("a/b"), {kept.last()});
        QCOMPARE(readTrendLayouts(settings, QStringLiteral("a/b")), QList<TrendLayout>{kept.last()});
        QVERIFY(readTrendLayouts(settings, QStringLiteral("c")).isEmpty());
    }

    void damagedLayouts()
    {
        QSettings settings(m_folder.filePath(QStringLiteral("b.ini")), QSettings::IniFormat);
        settings.setValue(QStringLiteral("x/size"), 1);
        settings.setValue(QStringLiteral("x/1/curves"), QStringLiteral("12:1 12 :: 5:99 a:b 7:0 8:14 7:16 4:21 4:22"));
        settings.setValue(QStringLiteral("x/1/seconds"), QStringLiteral("-5"));
        const QList<TrendLayout> read = readTrendLayouts(settings, QStringLiteral("x"));
        QCOMPARE(read.size(), 1);
        QCOMPARE(
            read.first().curves,
            (QList<SeriesKey>{
                {12, Quantity::TiltX}, {8, Quantity::SampleY}, {7, Quantity::DisplacementY}, {4, Quantity::Humidity}}));
        QCOMPARE(read.first().span, std::chrono::seconds(3600));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestTrendCsv)
#include "tst_trendcsv.moc"
