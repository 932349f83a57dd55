// What a second of a weather station costs: 64 parameters with all corrections from 64 channels × 1 kHz, as share of a core, and how
// it grows with the length of the windows. Build it with the preset release.
#include "core/station/secondaccumulator.h"
#include "core/station/stationpipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

using namespace gorizont;
using namespace gorizont::station;

namespace {

constexpr int parameters = 64;
constexpr int samplesPerSecond = 1000; ///< of each channel
constexpr int rounds = 5;

Corrections allCorrections()
{
    CorrectionTable table;
    for (int row = 0; row < 8; ++row) {
        table.rows.append({row * 10.0 - 35, {0.01, -0.0002, 0.000003, 0.00000001}});
    }
    Corrections corrections;
    corrections.input = table;
    corrections.meteo = table;
    corrections.correct = table;
    corrections.real.byTemperature = {{-1.0, -0.013, 0.003}, {0.08, -0.009, 0.0003}, {0.001, 0.0001}};
    return corrections;
}

/// A supply, a thermometer, a mast with wind, the others with letters of their own; all with ten coefficients.
StationConfig stationWith(std::chrono::seconds window)
{
    StationConfig config;
    config.settings.averaging = window;
    const QString codes = QStringLiteral("UTAM");
    for (int i = 0; i < parameters; ++i) {
        ParameterConfig parameter;
        parameter.code = i < codes.size() ? codes.at(i) : QChar(u'B');
        parameter.number = i < codes.size() ? 1 : i;
        parameter.conversion = {0.1, {0, 1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}};
        parameter.limits = {-1e6, 1e6};
        parameter.error = 1e3;
        config.parameters.append(parameter);
        config.corrections.append(allCorrections());
    }
    return config;
}

/// One second of all channels, interleaved: a slow wave with noise, different in every second.
std::vector<double> samples(int second)
{
    std::vector<double> scans(static_cast<std::size_t>(parameters) * samplesPerSecond);
    quint32 noise = 12345U + static_cast<quint32>(second);
    for (double &sample : scans) {
        noise = noise * 1664525U + 1013904223U;
        sample = 3 + std::sin(second * 0.01) + noise * 1e-10;
    }
    return scans;
}

double processorSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// Processor time of a second of a station, with all samples, in seconds.
double wholeSecond()
{
    constexpr int seconds = 300;
    StationPipeline pipeline(stationWith(std::chrono::seconds(600)));
    SecondAccumulator accumulator(parameters);
    std::vector<std::vector<double>> supply;
    supply.reserve(10);
    for (int i = 0; i < 10; ++i) {
        supply.push_back(samples(i));
    }
    const double start = processorSeconds();
    for (int i = 0; i < seconds; ++i) {
        accumulator.addScans(supply[static_cast<std::size_t>(i) % supply.size()]);
        pipeline.step({SteadyTime(std::chrono::seconds(i)), i, accumulator.take(), 0U});
    }
    return (processorSeconds() - start) / seconds;
}

/// Processor time of the pipeline alone, a second, once its windows are full.
double fullWindow(std::chrono::seconds window)
{
    constexpr int seconds = 20'000;
    StationPipeline pipeline(stationWith(window));
    quint32 noise = 1;
    int clock = 0;
    const auto run = [&](qint64 count) {
        RawSecond second;
        second.raw.resize(parameters);
        for (qint64 i = 0; i < count; ++i) {
            for (auto &raw : second.raw) {
                noise = noise * 1664525U + 1013904223U;
                raw = 3 + std::sin(clock * 0.001) + noise * 1e-10;
            }
            second.time = SteadyTime(std::chrono::seconds(clock++));
            pipeline.step(second);
        }
    };
    run(window.count());
    const double start = processorSeconds();
    run(seconds);
    return (processorSeconds() - start) / seconds;
}

template <typename Run> double best(int times, const Run &run)
{
    double least = 1e9;
    for (int i = 0; i < times; ++i) {
        least = std::min(least, run());
    }
    return least;
}

} // namespace

int main()
{
    const double second = best(rounds, wholeSecond);
    std::printf(
        "%d parameters with all corrections from %d channels x %d Hz: %.0f us a second, %.3f %% of a core\n",
        parameters, parameters, samplesPerSecond, second * 1e6, second * 100);
    double shortest = 0;
    for (const int window : {60, 600, 3600, 86400}) {
        const double cost = best(3, [window] { return fullWindow(std::chrono::seconds(window)); });
        shortest = shortest > 0 ? shortest : cost;
        std::printf("window of %5d s: %.1f us a second, %.2f of the shortest\n", window, cost * 1e6, cost / shortest);
    }
    return 0;
}
