#include "core/values/vibrationcapture.h"

#include <cmath>

namespace gorizont {

/// One-sided: the halves of both signs of a frequency count, except at 0.
QList<SpectrumBin> spectrumOf(const CaptureInformation &information, const QList<qint32> &codes, CodeUnit unit)
{
    const double scale = std::abs(information.scale(unit));
    const double windowPower = information.rate * information.windowSum2;
    const qsizetype bins = codes.size() / 2;
    QList<SpectrumBin> spectrum;
    spectrum.reserve(bins);
    for (qsizetype k = 0; k < bins; ++k) {
        const double modulus = scale * std::hypot(codes.at(2 * k), codes.at(2 * k + 1));
        const int sides = k == 0 ? 1 : 2;
        spectrum.append(
            {static_cast<double>(k) * information.rate / (2.0 * static_cast<double>(bins)),
             sides * modulus / information.windowSum, windowPower > 0 ? sides * modulus * modulus / windowPower : 0});
    }
    return spectrum;
}

} // namespace gorizont
