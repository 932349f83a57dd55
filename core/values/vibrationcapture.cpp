#include "core/values/vibrationcapture.h"

#include <cmath>

namespace gorizont {

QList<SpectrumBin> spectrumOf(const CaptureInformation &information, const QList<qint32> &codes)
{
    const qsizetype bins = codes.size() / 2;
    QList<SpectrumBin> spectrum;
    spectrum.reserve(bins);
    for (qsizetype k = 0; k < bins; ++k) {
        const double modulus = std::hypot(codes.at(2 * k), codes.at(2 * k + 1));
        const double factor = (k == 0 ? 1 : 2) * std::abs(information.physicalK) / information.windowSum;
        spectrum.append(
            {static_cast<double>(k) * information.rate / (2.0 * static_cast<double>(bins)), factor * modulus});
    }
    return spectrum;
}

} // namespace gorizont
