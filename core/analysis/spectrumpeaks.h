#pragma once

#include "core/analysis/spectrum.h"

namespace gorizont {

/// A line of a spectrum, between its bins.
struct SpectrumPeak
{
    double frequency = 0; ///< Hz
    double amplitude = 0; ///< in the unit of the samples
    bool operator==(const SpectrumPeak &) const = default;
};

/// At most \a most lines that stand out of the noise, the strongest first. A line must be four times as high as the
/// median of all, which noise alone reaches once in thousands of lines; what lies within the main lobe of a stronger
/// line belongs to that.
QList<SpectrumPeak> peaks(const Spectrum &spectrum, int most);

} // namespace gorizont
