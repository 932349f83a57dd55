#include "ui/plots/curvegraphs.h"
#include "ui/plots/curvemodel.h"
#include "ui/plots/plottext.h"
#include "ui/plots/plottime.h"
#include "ui/plots/seriesfeed.h"

#include "tests/ui/contrast.h"
#include "tests/ui/modeltext.h"
#include "tests/ui/plotsource.h"
#include "tests/ui/samplesite.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime start{1'800'000'000s};

/// `0 1 | 5`: the values of a graph in the order of time, `|` where its line breaks.
QString drawn(const QCPGraph *graph)
{
    QStringList parts;
    for (const QCPGraphData &point : *graph->data()) {
        parts += std::isnan(point.value) ? QStringLiteral("|") : QString::number(point.value);
    }
    return parts.join(u' ');
}

} // namespace

/// From a series to what is painted, and the list in which curves are ticked.
class TestPlotCurves : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gapsBreakTheLine()
    {
        Series series;
        series.buckets = {value(0s, 1), value(1s, 2), value(9s, 3), value(10s, 4)};
        m_curve.setHistory(series, 10);
        QCOMPARE(drawn(m_curve.line()), QStringLiteral("10 20 30 40")); // nothing says that anything is missing
        series.gaps = {{start + 2s, start + 9s}};
        m_curve.setHistory(series, 10);
        QCOMPARE(drawn(m_curve.line()), QStringLiteral("10 20 | 30 40"));
        series.gaps = {
            {start - 5s, start}, {start + 2s, start + 3s}, {start + 4s, start + 9s}, {start + 11s, start + 20s}};
        m_curve.setHistory(series, 1);
        QCOMPARE(drawn(m_curve.line()), QStringLiteral("1 2 | 3 4 |"));
    }

    void invalidBucketsBreakTheLine()
    {
        Series series;
        series.buckets = {value(0s, 1), value(1s, 2), {start + 2s, 0, 0, 0, 1, 0}, value(3s, 3), value(4s, 3)};
        m_curve.setHistory(series, 1);
        QCOMPARE(drawn(m_curve.line()), QStringLiteral("1 2 | 3 3"));
    }

    /// Buckets of no value may be left out; a gap shorter than a bucket that has values does not show at this scale.
    void bucketsThatAreLeftOutBreakTheLine()
    {
        Series series;
        series.step = 60s;
        series.buckets = {value(0s, 1), value(60s, 2), value(240s, 3), value(300s, 4), value(360s, 5)};
        series.gaps = {{start + 120s, start + 240s}, {start + 310s, start + 320s}};
        m_curve.setHistory(series, 1);
        QCOMPARE(drawn(m_curve.line()), QStringLiteral("1 2 | 3 4 5"));
        QCOMPARE(m_curve.line()->data()->constBegin()->key, toKey(start + 30s)); // in the middle of its minute
    }

    void bandsWhereABucketHoldsMuch()
    {
        Series series;
        series.step = 60s;
        series.buckets = {{start, -1, 0, 2, 60, 60}, {start + 60s, -3, 0, 4, 60, 50}};
        m_curve.setHistory(series, 2);
        QCOMPARE(drawn(m_plot.graph(0)), QStringLiteral("-2 -6"));
        QCOMPARE(drawn(m_plot.graph(1)), QStringLiteral("4 8"));
        QCOMPARE(m_plot.graph(1)->channelFillGraph(), m_plot.graph(0));
        const std::optional<QCPRange> range = m_curve.valueRange({toKey(start), toKey(start + 2min)});
        QVERIFY(range);
        QCOMPARE(range->lower, -6.0);
        QCOMPARE(range->upper, 8.0);
        series.step = 0s;
        m_curve.setHistory(series, 1);
        QCOMPARE(drawn(m_plot.graph(0)), QString());
    }

    /// A line needs two ends; a value alone is a dot.
    void aValueAloneIsSeen()
    {
        Series series;
        series.buckets = {value(0s, 1), value(10s, 2), value(11s, 2), value(20s, 3)};
        series.gaps = {{start + 1s, start + 10s}, {start + 12s, start + 20s}, {start + 21s, start + 30s}};
        m_curve.setHistory(series, 1);
        QCOMPARE(drawn(m_plot.graph(3)), QStringLiteral("1 3"));
    }

    void theEdgeGoesOn()
    {
        Series series;
        series.buckets = {value(0s, 1), value(1s, 2)};
        m_curve.setHistory(series, 1);
        m_curve.append({value(1s, 2), value(2s, 3)});
        m_curve.append({value(2s, 3), {start + 3s, 0, 0, 0, 1, 0}, value(4s, 5)});
        QCOMPARE(drawn(m_curve.line()), QStringLiteral("1 2 3 | 5"));
    }

    /// Without an archive nothing ever takes the readings over: a month must not fill the memory.
    void theOldestGo()
    {
        for (int i = 0; i < 3 * SeriesFeed::mostLive; ++i) {
            m_curve.append({value(i * 1s, i)});
        }
        QVERIFY(m_curve.line()->dataCount() <= SeriesFeed::mostLive);
        QVERIFY(m_curve.line()->dataCount() > SeriesFeed::mostLive / 2);
        QCOMPARE((m_curve.line()->data()->constEnd() - 1)->value, 3.0 * SeriesFeed::mostLive - 1);
    }

    void nothingIsDrawnOfNothing()
    {
        m_curve.setHistory({}, 1);
        QVERIFY(!m_curve.valueRange({toKey(start), toKey(start + 1h)}));
        QCOMPARE(drawn(m_curve.line()), QString());
    }

    void stylesDiffer()
    {
        for (const bool isDark : {false, true}) {
            const QColor background = isDark ? QColor(0x1f, 0x22, 0x26) : QColor(Qt::white);
            QList<CurveStyle> styles;
            for (int i = 0; i < CurveModel::mostCurves; ++i) {
                const CurveStyle style = curveStyle(i, isDark);
                QVERIFY(!styles.contains(style));
                QVERIFY2(test::contrast(style.colour, background) >= 3, qPrintable(style.colour.name()));
                styles.append(style);
            }
            QVERIFY(styles.at(0).colour != styles.at(1).colour && styles.at(0).line != styles.at(1).line);
        }
    }

    void theList()
    {
        CurveModel model(m_registry);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(
            test::modelText(model),
            QStringLiteral("1 АН-Д3 [Этаж 2] [12]\n  Mx\n  My\n  T\n  P of the heater\n  Frequency of the fan\n  Amax\n"
                           "  Amax X\n  Amax Y\n  Arms\n  Arms X\n  Arms Y\n  Direction of Amax\n  Ax\n  Ay\n"
                           "2 ИН-Д3 [24]\n  Mx\n  My\n3 ИН-Д3 [5]\n  Mx\n  My\n4 ИН-Д3 [6]\n  Mx\n  My"));
        const QSignalSpy changed(&model, &CurveModel::chosenChanged);
        const SeriesKey key{2, Quantity::TiltY};
        QVERIFY(model.setData(model.indexOf(key), Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(model.chosen(), QList<SeriesKey>{key});
        QCOMPARE(model.indexOf(key).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        model.addSensor(1);
        QCOMPARE(model.chosen(), (QList<SeriesKey>{key, {1, Quantity::TiltX}, {1, Quantity::TiltY}}));
        model.addSensor(1);
        model.addSensor(77);
        QCOMPARE(model.chosen().size(), 3);
        QVERIFY(model.setData(model.indexOf(key), Qt::Unchecked, Qt::CheckStateRole));
        QCOMPARE(model.chosen().size(), 2);
        QCOMPARE(changed.size(), 3);
        QVERIFY(!model.setData(model.index(0, 0), Qt::Checked, Qt::CheckStateRole)); // a sensor as a whole
        model.setChosen({{77, Quantity::TiltX}, {2, Quantity::Temperature}, key, key});
        QCOMPARE(model.chosen(), QList<SeriesKey>{key});
    }

    void notMoreThanCanBeToldApart()
    {
        ServerConfig config = test::sampleConfig();
        for (int number = 10; number < 40; ++number) {
            SensorConfig sensor = config.lines.first().sensors.last();
            sensor.number = number;
            config.lines.first().sensors.append(sensor);
        }
        const SensorRegistry registry(config.lines, StatusRules());
        CurveModel model(registry);
        for (int number = 10; number < 40; ++number) {
            model.addSensor(number);
        }
        QCOMPARE(model.chosen().size(), CurveModel::mostCurves);
        QVERIFY(!model.setData(model.indexOf({39, Quantity::TiltX}), Qt::Checked, Qt::CheckStateRole));
    }

    void textsOfValues()
    {
        const auto tilt = ValueAxis::Tilt;
        QCOMPARE(plottext::value(-0.0755, tilt, TiltUnit::Degrees), QStringLiteral("-0.0755"));
        QCOMPARE(plottext::signedValue(12.34, tilt, TiltUnit::ArcSeconds), QStringLiteral("+12.3"));
        QCOMPARE(plottext::value({}, tilt, TiltUnit::Degrees), QStringLiteral("—"));
        QCOMPARE(plottext::scaleOf(Quantity::TiltX, TiltUnit::Degrees) * 3600, 1.0);
        QCOMPARE(plottext::scaleOf(Quantity::TiltX, TiltUnit::ArcSeconds), 1.0);
        QCOMPARE(plottext::scaleOf(Quantity::AccelDirection, TiltUnit::Degrees), 1.0);
        QCOMPARE(
            plottext::curve(m_registry.sensors().front().config, Quantity::AccelRms),
            QStringLiteral("1 АН-Д3 [Этаж 2] Arms"));
        QCOMPARE(plottext::duration(26h + 3min + 4s), QStringLiteral("1 d 02:03:04"));
        QCOMPARE(plottext::duration(59s), QStringLiteral("00:00:59"));
    }

    /// A microsecond survives the way to the axis and back.
    void timesOfTheAxis()
    {
        const UtcTime time = start + 123456us;
        QCOMPARE(toTime(toKey(time)), time);
        QCOMPARE(toKey(start), 1.8e9);
    }

private:
    static SeriesBucket value(std::chrono::microseconds after, double number)
    {
        return test::reading(start + after, number);
    }

    QCustomPlot m_plot;
    CurveGraphs m_curve{m_plot, m_plot.yAxis, QStringLiteral("curve"), curveStyle(0, false)};
    SensorRegistry m_registry{test::sampleConfig().lines, StatusRules()};
};

QTEST_MAIN(TestPlotCurves)
#include "tst_plotcurves.moc"
