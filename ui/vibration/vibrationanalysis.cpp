#include "ui/vibration/vibrationanalysis.h"

#include <QPromise>
#include <QThreadPool>

#include <memory>

namespace gorizont {

namespace {

constexpr int mostPeaks = 5;
constexpr double leastOfHighest = 1e-3; ///< what is lower says nothing to an operator

QList<SpectrumPeak> highestOf(const Spectrum &spectrum)
{
    QList<SpectrumPeak> found = peaks(spectrum, mostPeaks);
    const double least = found.isEmpty() ? 0 : leastOfHighest * found.constFirst().amplitude;
    found.removeIf([least](const SpectrumPeak &peak) { return peak.amplitude < least; });
    return found;
}

} // namespace

VibrationSpectrum ownSpectrum(
    const lvims::CaptureInformation &information, const QList<qint32> &codes, lvims::CodeUnit unit)
{
    QList<double> samples;
    samples.reserve(codes.size());
    for (const qint32 code : codes) {
        samples.append(information.value(code, unit));
    }
    SpectrumSettings settings;
    settings.window = SpectrumWindow::Hann;
    settings.length = samples.size();
    VibrationSpectrum result{spectrum({samples}, information.rate, settings), {}};
    result.peaks = highestOf(result.lines);
    return result;
}

QFuture<VibrationSpectrum> ownSpectrumLater(
    const lvims::CaptureInformation &information, const QList<qint32> &codes, lvims::CodeUnit unit)
{
    auto promise = std::make_shared<QPromise<VibrationSpectrum>>();
    promise->start();
    QFuture<VibrationSpectrum> future = promise->future();
    QThreadPool::globalInstance()->start([promise, information, codes, unit] {
        if (!promise->isCanceled()) {
            promise->addResult(ownSpectrum(information, codes, unit));
        }
        promise->finish();
    });
    return future;
}

/// The constant part is no tone: it would hide everything else.
VibrationSpectrum spectrumOfModule(
    const lvims::CaptureInformation &information, const QList<qint32> &codes, lvims::CodeUnit unit)
{
    VibrationSpectrum result;
    const auto bins = lvims::spectrumOf(information, codes, unit);
    result.lines.window = SpectrumWindow::Blackman;
    result.lines.length = codes.size();
    result.lines.segments = 1;
    for (const lvims::SpectrumBin &bin : bins) {
        result.lines.amplitude.append(bin.amplitude);
        result.lines.density.append(bin.density);
    }
    result.lines.resolution = bins.size() > 1 ? bins.at(1).frequency : 0;
    result.peaks = highestOf(result.lines);
    return result;
}

} // namespace gorizont
