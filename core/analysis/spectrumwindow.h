#pragma once

#include <QList>

namespace gorizont {

/// By what a segment is multiplied before its transform. All are sums of cosines in their periodic form,
/// w[n] = Σ (−1)ʲ aⱼ cos(2πjn/N).
enum class SpectrumWindow : quint8 { Rectangular, Hann, Hamming, BlackmanHarris, Blackman };

/// The \a length weights of \a window, 0 ≤ w ≤ 1.
QList<double> windowWeights(SpectrumWindow window, qsizetype length);

/// What a sine of amplitude 1 shows \a offset bins beside its frequency, relative to what it shows there; long segments.
double windowResponse(SpectrumWindow window, double offset);

/// Half the width of the main lobe, bins: what lies nearer than this to a line belongs to it.
int mainLobe(SpectrumWindow window);

} // namespace gorizont
