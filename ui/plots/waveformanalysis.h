#pragma once

#include "core/analysis/spectrumpeaks.h"
#include "core/values/series.h"

namespace gorizont {

/// Everything that is computed of the samples of one axis.
struct WaveformAnalysis
{
    Spectrum spectrum;
    QList<SpectrumPeak> peaks; ///< the strongest first
};

/// Of X and of Y.
using WaveformAnalyses = std::pair<WaveformAnalysis, WaveformAnalysis>;

/// What of both series lies within \a seen, on a thread of the global pool; nothing is computed for a future that was
/// cancelled before its turn.
QFuture<WaveformAnalyses> analysed(
    const Series &x, const Series &y, const TimeSpan &seen, const SpectrumSettings &settings);

} // namespace gorizont
