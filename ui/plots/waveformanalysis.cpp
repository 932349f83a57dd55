#include "ui/plots/waveformanalysis.h"

#include "core/analysis/samplestretches.h"
#include "ui/plots/spanpage.h"

#include <QPromise>
#include <QThreadPool>

#include <memory>

namespace gorizont {

namespace {

constexpr int mostPeaks = 3;

WaveformAnalysis analysisOf(const Series &series, const TimeSpan &seen, const SpectrumSettings &settings)
{
    const SampleStretches samples = sampleStretches(trimmed(series, seen));
    WaveformAnalysis analysis{spectrum(samples.stretches, samples.rate, settings), {}};
    analysis.peaks = peaks(analysis.spectrum, mostPeaks);
    return analysis;
}

} // namespace

QFuture<WaveformAnalyses> analysed(
    const Series &x, const Series &y, const TimeSpan &seen, const SpectrumSettings &settings)
{
    auto promise = std::make_shared<QPromise<WaveformAnalyses>>();
    promise->start();
    QFuture<WaveformAnalyses> future = promise->future();
    QThreadPool::globalInstance()->start([promise, x, y, seen, settings] {
        if (!promise->isCanceled()) {
            promise->addResult(WaveformAnalyses{analysisOf(x, seen, settings), analysisOf(y, seen, settings)});
        }
        promise->finish();
    });
    return future;
}

} // namespace gorizont
