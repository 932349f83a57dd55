#pragma once

#include "core/analysis/spectrumwindow.h"

#include <QList>

namespace gorizont {

struct SpectrumSettings
{
    SpectrumWindow window = SpectrumWindow::Hann;
    qsizetype length = 4096; ///< samples of a segment, at least 8
    double overlap = 0.5; ///< of neighbouring segments, 0 ≤ overlap < 1
    bool operator==(const SpectrumSettings &) const = default;
};

/// A one-sided spectrum by Welch's method: the powers of overlapping segments are averaged, each without its mean. Line
/// k stands at k × resolution; the last is half the sampling rate if the length of a segment is even.
struct Spectrum
{
    SpectrumWindow window = SpectrumWindow::Hann;
    double resolution = 0; ///< Hz between two lines
    qsizetype length = 0; ///< samples of a segment, which may be fewer than wanted
    qsizetype segments = 0; ///< that were averaged
    QList<double> amplitude; ///< of a sine that would stand there, in the unit of the samples
    QList<double> density; ///< power density, unit² / Hz: its sum × resolution is the variance
};

/// The spectrum of stretches of samples that are \a rate Hz apart; nothing is taken across the ends of a stretch. Where
/// no stretch is as long as a segment, the segment becomes as long as the longest stretch. Empty: less than 8 samples,
/// or a rate that is no positive number. Any thread.
Spectrum spectrum(const QList<QList<double>> &stretches, double rate, const SpectrumSettings &settings);

} // namespace gorizont
