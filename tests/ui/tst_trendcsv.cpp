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

QList<CsvCurve> sample()
{
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
        {QStringLiteral("1 АН-Д3; \"Этаж\" Mx"), QStringLiteral("°"), 1.0 / 3600, tilt},
        {QStringLiteral("2 T"), QStringLiteral("°C"), 1, mean}};
}

} // namespace

/// What a table of a trend looks like, and what a layout is kept as.
class TestTrendCsv : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void russianExcel()
    {
        const QByteArray table = trendCsv(sample(), {start, start + 10s}, CsvForm::RussianExcel, QTimeZone(3 * 3600));
        QVERIFY(table.startsWith("\xEF\xBB\xBF"));
        QCOMPARE(
            QString::fromUtf8(table.mid(3)),
            QStringLiteral("Time;\"1 АН-Д3; \"\"Этаж\"\" Mx, °\";2 T, °C;2 T, °C, min.;2 T, °C, max.\r\n"
                           "07.02.2018 18:33:03,000;1;21;20,5;22,25\r\n"
                           "07.02.2018 18:33:04,500;-0,25;;;\r\n"
                           "07.02.2018 18:33:05,000;;;;\r\n"));
    }

    void iso()
    {
        const QByteArray table = trendCsv(sample(), {start, start + 10s}, CsvForm::Iso, QTimeZone(3 * 3600));
        QCOMPARE(
            QString::fromUtf8(table),
            QStringLiteral("Time,\"1 АН-Д3; \"\"Этаж\"\" Mx, °\",\"2 T, °C\",\"2 T, °C, min.\",\"2 T, °C, max.\"\r\n"
                           "2018-02-07T18:33:03.000+03:00,1,21,20.5,22.25\r\n"
                           "2018-02-07T18:33:04.500+03:00,-0.25,,,\r\n"
                           "2018-02-07T18:33:05.000+03:00,,,,\r\n"));
    }

    void nothingSeen()
    {
        QCOMPARE(trendCsv({}, {start, start + 1h}, CsvForm::Iso, QTimeZone::utc()), QByteArray("Time\r\n"));
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
        settings.setValue(QStringLiteral("x/1/curves"), QStringLiteral("12:1 12 :: 5:99 a:b 7:0 8:14"));
        settings.setValue(QStringLiteral("x/1/seconds"), QStringLiteral("-5"));
        const QList<TrendLayout> read = readTrendLayouts(settings, QStringLiteral("x"));
        QCOMPARE(read.size(), 1);
        QCOMPARE(read.first().curves, (QList<SeriesKey>{{12, Quantity::TiltX}, {8, Quantity::SampleY}}));
        QCOMPARE(read.first().span, std::chrono::seconds(3600));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestTrendCsv)
#include "tst_trendcsv.moc"
