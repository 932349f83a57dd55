#include "ui/plots/xypage.h"

#include "tests/ui/plotsource.h"
#include "tests/ui/samplesite.h"
#include "ui/plots/curvestyle.h"
#include "ui/plots/plotting.h"
#include "ui/plots/waveformpage.h"

#include <QtTest>

#include <numbers>
#include <numeric>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime present{1'800'000'000s};

Series series(SeriesKey key, const QList<double> &values)
{
    Series made{key, 0s, {}, {}};
    for (qsizetype i = 0; i < values.size(); ++i) {
        made.buckets.append(test::reading(present - 9min + i * 1s, values.at(i)));
    }
    return made;
}

Series samples(SeriesKey key, double frequency, double amplitude)
{
    Series made{key, 0s, {}, {}};
    for (int i = 0; i < 4096; ++i) {
        const double angle = 2 * std::numbers::pi * frequency * i / 10;
        made.buckets.append(test::reading(present - 9min + i * 100ms, amplitude * std::sin(angle)));
    }
    return made;
}

} // namespace

/// The pages of one sensor: hodograph and waveform.
class TestXyPlot : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_source = std::make_unique<test::PlotSource>(); }

    void pairsOfOneMoment()
    {
        Series x = series({1, Quantity::TiltX}, {1, 2, 3, 4, 5, 6});
        Series y = series({1, Quantity::TiltY}, {10, 20, 30, 40, 50, 60});
        y.buckets.removeAt(1);
        x.buckets[4].valid = 0;
        QCOMPARE(way(hodograph(x, y)), QStringLiteral("1,10 | 3,30 4,40 | 6,60"));
        x.gaps = {{present - 9min + 2500ms, present - 9min + 3s}};
        QCOMPARE(way(hodograph(x, y)), QStringLiteral("1,10 | 3,30 | 4,40 | 6,60"));
        QVERIFY(hodograph(x, {}).isEmpty());
    }

    void bothScalesAreEqual()
    {
        XyPage page(m_registry, m_source->source(), nullptr, [] { return present; });
        page.resize(900, 500);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        page.showSensor(2);
        const SeriesKey x{2, Quantity::TiltX};
        const SeriesKey y{2, Quantity::TiltY};
        m_source->answer(m_source->questions.size() - 1, {series(x, {0, 100, 100, 0}), series(y, {0, 0, 20, 20})});
        auto *plot = page.findChild<QCustomPlot *>(QStringLiteral("xyPlot"));
        QTRY_VERIFY(plot->xAxis->range().size() > 100);
        QTest::qWait(100);
        const double across = plot->xAxis->range().size() / plot->axisRect()->width();
        const double up = plot->yAxis->range().size() / plot->axisRect()->height();
        QVERIFY(std::abs(across / up - 1) < 0.01);
        QVERIFY(plot->xAxis->range().contains(0) && plot->xAxis->range().contains(100));
        QVERIFY(plot->yAxis->range().contains(0) && plot->yAxis->range().contains(20));
        const auto *start = plot->findChildren<QCPItemTracer *>().constFirst();
        QCOMPARE(start->position->coords(), QPointF(0, 0));
        const auto *end = plot->findChildren<QCPItemTracer *>().constLast();
        QCOMPARE(end->position->coords(), QPointF(0, 20));
        QVERIFY(!page.findChild<QLabel *>(QStringLiteral("spanHint"))->isVisible());
        page.findChild<QComboBox *>(QStringLiteral("tiltUnit"))->setCurrentIndex(0);
        QCOMPARE(end->position->coords(), QPointF(0, 20.0 / 3600));
    }

    void nothingToShowIsSaid()
    {
        XyPage page(m_registry, m_source->source(), nullptr, [] { return present; });
        page.show();
        m_source->answer(m_source->questions.size() - 1, {{}, {}});
        auto *hint = page.findChild<QLabel *>(QStringLiteral("spanHint"));
        QTRY_VERIFY(hint->isVisible());
        QVERIFY(hint->text().contains(QStringLiteral("no angles in this span")));
        ServerConfig config = test::sampleConfig();
        config.lines.first().sensors.removeFirst(); // the only accelerometer
        SensorRegistry registry(config.lines, StatusRules());
        WaveformPage wave(registry, m_source->source(), nullptr, [] { return present; });
        wave.show();
        auto *text = wave.findChild<QLabel *>(QStringLiteral("spanHint"));
        QVERIFY(text->isVisible());
        QVERIFY(text->text().contains(QStringLiteral("No sensor")));
    }

    void frequenciesOfAWaveform()
    {
        WaveformPage page(m_registry, m_source->source(), nullptr, [] { return present; });
        page.resize(900, 600);
        page.show();
        QCOMPARE(page.sensor(), 1);
        QCOMPARE(m_source->questions.back().query.width, 0); // at full rate
        const SeriesKey x{1, Quantity::SampleX};
        const SeriesKey y{1, Quantity::SampleY};
        m_source->answer(m_source->questions.size() - 1, {samples(x, 0.213, 4), samples(y, 1.75, 0.5)});
        auto *state = page.findChild<QLabel *>(QStringLiteral("spanState"));
        QTRY_VERIFY2(state->text().contains(QStringLiteral("Ax: 0.213 Hz (4.00)")), qPrintable(state->text()));
        QVERIFY2(state->text().contains(QStringLiteral("Ay: 1.750 Hz (0.50)")), qPrintable(state->text()));
        QVERIFY(state->text().contains(QStringLiteral("Segments averaged: 7,")));
        auto *plot = page.findChild<QCustomPlot *>(QStringLiteral("spectrumPlot"));
        QCOMPARE(plot->graph(0)->dataCount(), 512);
        auto *lengths = page.findChild<QComboBox *>(QStringLiteral("spectrumLength"));
        lengths->setCurrentIndex(lengths->findData(4096));
        QTRY_VERIFY(state->text().contains(QStringLiteral("Segments averaged: 1,")));
        QCOMPARE(plot->graph(0)->dataCount(), 2048);
        auto *windows = page.findChild<QComboBox *>(QStringLiteral("spectrumWindow"));
        const double narrow = sumOf(plot->graph(0));
        windows->setCurrentIndex(windows->findData(int(SpectrumWindow::BlackmanHarris)));
        QTRY_VERIFY(sumOf(plot->graph(0)) > 1.2 * narrow); // its lines are the widest
        QVERIFY(state->text().contains(QStringLiteral("Ax: 0.213 Hz (4.00)")));
    }

    /// The answer reaches beyond what is seen: spectrum and scale are of what is seen.
    void theSpectrumBelongsToTheSpan()
    {
        WaveformPage page(m_registry, m_source->source(), nullptr, [] { return present; });
        page.resize(900, 600);
        page.show();
        page.showSpan({present - 9min, present});
        QTRY_VERIFY(m_source->questions.back().query.from < present - 10min);
        Series x = samples({1, Quantity::SampleX}, 0.213, 4);
        x.buckets.last() = test::reading(x.buckets.last().from, 500); // an impact
        m_source->answer(m_source->questions.size() - 1, {x, samples({1, Quantity::SampleY}, 1.75, 0.5)});
        auto *state = page.findChild<QLabel *>(QStringLiteral("spanState"));
        QTRY_VERIFY2(state->text().contains(QStringLiteral("Segments averaged: 7,")), qPrintable(state->text()));
        const auto *wave = page.findChild<QCustomPlot *>(QStringLiteral("wavePlot"));
        QVERIFY(wave->yAxis->range().upper > 500);
        const std::size_t asked = m_source->questions.size();
        page.showSpan({present - 9min, present - 9min + 160s});
        QTRY_VERIFY2(state->text().contains(QStringLiteral("Segments averaged: 2,")), qPrintable(state->text()));
        QVERIFY(wave->yAxis->range().upper < 5);
        QCOMPARE(m_source->questions.size(), asked); // all of it was known
    }

    /// A page that is closed while its samples are analysed takes nothing with it.
    void thePageEndsBeforeItsAnalysis()
    {
        for (int i = 0; i < 20; ++i) {
            WaveformPage page(m_registry, m_source->source(), nullptr, [] { return present; });
            page.show();
            const Series x = samples({1, Quantity::SampleX}, 0.213, 4);
            m_source->answer(m_source->questions.size() - 1, {x, samples({1, Quantity::SampleY}, 1.75, 0.5)});
            auto *state = page.findChild<QLabel *>(QStringLiteral("spanState"));
            QTRY_VERIFY(!state->text().contains(QStringLiteral("Reading…")));
        }
        QThreadPool::globalInstance()->waitForDone();
        QCoreApplication::processEvents();
    }

    void coloursFollowTheDesktop()
    {
        WaveformPage wave(m_registry, m_source->source(), nullptr, [] { return present; });
        XyPage way(m_registry, m_source->source(), nullptr, [] { return present; });
        const QPalette dark(QColor(0x20, 0x22, 0x26));
        wave.setPalette(dark);
        way.setPalette(dark);
        for (const QString &name : {QStringLiteral("wavePlot"), QStringLiteral("spectrumPlot")}) {
            const auto *plot = wave.findChild<QCustomPlot *>(name);
            QCOMPARE(plot->graph(0)->pen().color(), curveStyle(0, true).colour);
            QCOMPARE(plot->xAxis->tickLabelColor(), dark.color(QPalette::Text));
        }
        const auto *plot = way.findChild<QCustomPlot *>(QStringLiteral("xyPlot"));
        QCOMPARE(plot->xAxis->tickLabelColor(), dark.color(QPalette::Text));
        for (const QCPItemTracer *mark : plot->findChildren<QCPItemTracer *>()) {
            QCOMPARE(mark->pen().color(), dark.color(QPalette::Text));
        }
    }

    void theSpanIsChosen()
    {
        XyPage page(m_registry, m_source->source(), nullptr, [] { return present; });
        page.findChild<QAction *>(QStringLiteral("range86400"))->trigger();
        QCOMPARE(page.span(), (TimeSpan{present - 24h, present}));
        page.showSpan({present - 48h, present - 47h});
        page.findChild<QAction *>(QStringLiteral("range600"))->trigger();
        QCOMPARE(page.span(), (TimeSpan{present - 47h - 10min, present - 47h}));
        QVERIFY(!page.isFollowing());
        page.findChild<QAction *>(QStringLiteral("followAction"))->trigger();
        QCOMPARE(page.span(), (TimeSpan{present - 10min, present}));
    }

private:
    static double sumOf(const QCPGraph *graph)
    {
        return std::accumulate(
            graph->data()->constBegin(), graph->data()->constEnd(), 0.0,
            [](double sum, const auto &line) { return sum + line.value; });
    }

    /// `1,10 | 3,30`: places, `|` where the way breaks.
    static QString way(const QList<HodographPoint> &points)
    {
        QStringList parts;
        for (const HodographPoint &point : points) {
            if (!point.isJoined && !parts.isEmpty()) {
                parts += QStringLiteral("|");
            }
            parts += QStringLiteral("%1,%2").arg(point.place.x()).arg(point.place.y());
        }
        return parts.join(u' ');
    }

    std::unique_ptr<test::PlotSource> m_source;
    SensorRegistry m_registry{test::sampleConfig().lines, StatusRules()};
};

QTEST_MAIN(TestXyPlot)
#include "tst_xyplot.moc"
