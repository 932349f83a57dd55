// What plots cost. `bench_plots [seconds]` prints the CPU of a trend of 4 × 100,000 points at 20 frames a second and its
// ratio to the same curves in a bare QCustomPlot, then the time from a year of six curves in memory to the painted frame of
// 1500 pixels. `bench_plots --shots FOLDER [ru|en] [dark]` writes pictures of the pages instead.

#include "ui/plots/trendspage.h"

#include "tests/ui/samplesite.h"
#include "translations/translation.h"
#include "ui/plots/plottime.h"
#include "ui/plots/trendplot.h"
#include "ui/plots/waveformpage.h"
#include "ui/plots/xypage.h"

#include <QApplication>
#include <QDir>
#include <QPromise>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

constexpr int curves = 4;
constexpr int points = 100'000;
constexpr QSize frame(1500, 700);

double threadSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A noisy swing: no two neighbouring values are the same.
double valueAt(int curve, double seconds)
{
    const double noise = std::sin(12.9898 * seconds + curve) * 43758.5453;
    return 100 * curve + 60 * std::sin(seconds / 900 + curve) + 12 * (noise - std::floor(noise));
}

const UtcTime present{1'800'000'000s};

Series full(const SeriesKey &key, int curve)
{
    Series series{key, 0s, {}, {}};
    series.buckets.reserve(points);
    for (int i = 0; i < points; ++i) {
        const double value = valueAt(curve, i);
        series.buckets.append({present - (points - i) * 1s, value, value, value, 1, 1});
    }
    return series;
}

/// Both are drawn by turns, a frame every 50 ms, each with a new value at its end and an edge that has moved.
void benchFrames(int seconds)
{
    TrendPlot ours;
    QCustomPlot bare;
    QList<TrendCurve> list;
    for (int i = 0; i < curves; ++i) {
        list.append({{i + 1, Quantity::TiltX}, QStringLiteral("curve"), curveStyle(i, false)});
    }
    ours.setCurves(list, TiltUnit::ArcSeconds);
    for (int i = 0; i < curves; ++i) {
        const Series series = full(list.at(i).key, i);
        ours.setSeries(series, {});
        QCPGraph *graph = bare.addGraph();
        graph->setPen(QPen(list.at(i).style.colour));
        for (const SeriesBucket &bucket : series.buckets) {
            graph->data()->add(QCPGraphData(toKey(bucket.from), bucket.mean));
        }
    }
    for (QCustomPlot *plot : {static_cast<QCustomPlot *>(&ours), &bare}) {
        plot->resize(frame);
        plot->show();
    }
    bare.yAxis->setRange(-100, 420);
    double oursTime = 0;
    double bareTime = 0;
    const int frames = seconds * 20;
    for (int i = 0; i < frames; ++i) {
        const UtcTime now = present + i * 50ms;
        const TimeSpan span{now - points * 1s, now};
        double before = threadSeconds();
        for (int curve = 0; curve < curves; ++curve) {
            const double value = valueAt(curve, points + i);
            ours.append(list.at(curve).key, {{now, value, value, value, 1, 1}});
        }
        ours.setSpan(span);
        ours.fitScales();
        ours.replot(QCustomPlot::rpImmediateRefresh);
        oursTime += threadSeconds() - before;
        before = threadSeconds();
        for (int curve = 0; curve < curves; ++curve) {
            bare.graph(curve)->addData(toKey(now), valueAt(curve, points + i));
        }
        bare.xAxis->setRange(toKey(span.from), toKey(span.to));
        bare.replot(QCustomPlot::rpImmediateRefresh);
        bareTime += threadSeconds() - before;
    }
    std::printf("%-46s %6.2f ms\n", "frame of 4 x 100,000 points, bare", 1000 * bareTime / frames);
    std::printf("%-46s %6.2f ms\n", "frame of 4 x 100,000 points, trend", 1000 * oursTime / frames);
    std::printf("%-46s %6.2f\n", "CPU / bare QCustomPlot", oursTime / bareTime);
    std::printf("%-46s %6.2f %%\n", "of a core at 20 frames a second", 100 * 20 * oursTime / frames);
}

Series banded(const SeriesKey &key, int curve, std::chrono::microseconds span, int buckets)
{
    Series series{key, span / buckets, {}, {}};
    for (int i = 0; i < buckets; ++i) {
        const double value = valueAt(curve, i * 40.0);
        series.buckets.append({present - span + i * series.step, value - 9, value, value + 7, 8640, 8600});
        if (i % 200 == 150) {
            series.gaps.append({series.buckets.last().from, series.buckets.last().from + series.step});
        }
    }
    return series;
}

void benchYear()
{
    TrendPlot plot;
    plot.resize(frame);
    plot.show();
    QList<TrendCurve> list;
    QList<Series> year;
    for (int i = 0; i < 6; ++i) {
        const SeriesKey key{i + 1, i % 2 == 0 ? Quantity::TiltX : Quantity::Temperature};
        list.append({key, QStringLiteral("curve"), curveStyle(i, false)});
        year.append(banded(key, i, 8760h, 2250));
    }
    plot.setSpan({present - 8760h, present});
    QList<double> times;
    for (int i = 0; i < 40; ++i) {
        const double before = threadSeconds();
        plot.setCurves(list, TiltUnit::ArcSeconds);
        for (const Series &series : year) {
            plot.setSeries(series, {});
        }
        plot.fitScales();
        plot.replot(QCustomPlot::rpImmediateRefresh);
        times.append(1000 * (threadSeconds() - before));
    }
    std::sort(times.begin(), times.end());
    std::printf("%-46s %6.2f ms\n", "a year of six curves with bands, to the frame", times.at(times.size() / 2));
}

/// Answers at once with swings, a band where a step is wanted, and a gap.
SeriesSource pictures()
{
    return [](const SeriesQuery &query) {
        QPromise<QList<Series>> promise;
        promise.start();
        QList<Series> answer;
        for (const SeriesKey &key : query.keys) {
            const bool isSample = key.quantity == Quantity::SampleX || key.quantity == Quantity::SampleY;
            const auto span = query.to - query.from;
            const auto period = isSample ? 100ms : std::max<std::chrono::microseconds>(1s, span / 1500);
            Series series{key, period > 10s ? period : 0s, {}, {}};
            const UtcTime hole = query.from + span * 2 / 5;
            series.gaps = {{hole, hole + span / 25}};
            for (UtcTime time = query.from; time < std::min(query.to, utcNow()); time += period) {
                const double t = std::chrono::duration<double>(time - query.from) / std::chrono::duration<double>(span);
                const double phase = static_cast<double>(key.quantity) + key.number;
                double value = 90 * std::sin(7 * t + phase) + 14 * std::sin(53 * t) + valueAt(0, 1e4 * t) / 9;
                if (isSample) {
                    const double s = std::chrono::duration<double>(time - query.from).count();
                    value = 4 * std::sin(2 * std::numbers::pi * 0.213 * s) + std::sin(2 * std::numbers::pi * 1.7 * s)
                        + valueAt(0, s) / 60;
                }
                if (time < hole || time >= hole + span / 25) {
                    series.buckets.append({time, value - 12, value, value + 9, 60, 60});
                }
            }
            answer.append(series);
        }
        promise.addResult(answer);
        promise.finish();
        return promise.future();
    };
}

void shoot(QWidget &page, const QString &folder, const QString &name, QSize size)
{
    page.resize(size);
    page.show();
    QEventLoop loop;
    QTimer::singleShot(700, &loop, &QEventLoop::quit);
    loop.exec();
    page.grab().save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

void makeDark()
{
    QPalette dark;
    dark.setColor(QPalette::Window, QColor(0x2b, 0x2e, 0x33));
    dark.setColor(QPalette::WindowText, QColor(0xe6, 0xe6, 0xe6));
    dark.setColor(QPalette::Base, QColor(0x1f, 0x22, 0x26));
    dark.setColor(QPalette::Text, QColor(0xe6, 0xe6, 0xe6));
    dark.setColor(QPalette::Button, QColor(0x35, 0x39, 0x3f));
    dark.setColor(QPalette::ButtonText, QColor(0xe6, 0xe6, 0xe6));
    QApplication::setPalette(dark);
}

void takeShots(const QString &folder)
{
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    SensorRegistry registry(test::sampleConfig().lines, StatusRules());
    TrendsPage trends(registry, pictures());
    shoot(trends, folder, QStringLiteral("trends-empty"), {1000, 460});
    trends.showCurves({{1, Quantity::TiltX}, {2, Quantity::TiltY}, {1, Quantity::Temperature}});
    trends.follow(24h);
    shoot(trends, folder, QStringLiteral("trends-day"), {1000, 560});
    trends.findChild<QAction *>(QStringLiteral("cursorsAction"))->trigger();
    trends.follow(10min);
    shoot(trends, folder, QStringLiteral("trends-cursors"), {1000, 620});
    trends.showCurves(
        {{1, Quantity::TiltX},
         {1, Quantity::Temperature},
         {1, Quantity::AccelRms},
         {1, Quantity::AccelDirection},
         {2, Quantity::TiltX},
         {3, Quantity::TiltY},
         {4, Quantity::TiltX}});
    trends.follow(8760h);
    shoot(trends, folder, QStringLiteral("trends-year-narrow"), {700, 460});
    XyPage way(registry, pictures());
    shoot(way, folder, QStringLiteral("xy"), {900, 560});
    WaveformPage wave(registry, pictures());
    shoot(wave, folder, QStringLiteral("wave"), {900, 620});
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == QStringLiteral("--shots")) {
        installTranslation(arguments.value(3));
        if (arguments.value(4) == QStringLiteral("dark")) {
            makeDark();
        }
        takeShots(arguments.value(2, QStringLiteral(".")));
        return 0;
    }
    benchFrames(std::max(1, arguments.value(1, QStringLiteral("5")).toInt()));
    benchYear();
    return 0;
}
