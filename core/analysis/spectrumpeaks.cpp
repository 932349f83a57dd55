#include "core/analysis/spectrumpeaks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gorizont {

namespace {

constexpr double leastOverMedian = 4;
constexpr double leastOfHighest = 1e-6; ///< below is what rounding leaves

double median(QList<double> values)
{
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The offset, −½ … ½ bins, at which the window shows the neighbours of a line in the proportion in which they are:
/// exact for a lone sine.
double offsetOf(SpectrumWindow window, double left, double right)
{
    double low = -0.5;
    double high = 0.5;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        const bool isTooFarLeft =
            windowResponse(window, 1 - middle) * left < windowResponse(window, 1 + middle) * right;
        (isTooFarLeft ? low : high) = middle;
    }
    return (low + high) / 2;
}

SpectrumPeak between(const Spectrum &spectrum, qsizetype line)
{
    const double left = spectrum.amplitude.at(line - 1);
    const double middle = spectrum.amplitude.at(line);
    const double right = spectrum.amplitude.at(line + 1);
    const bool isOnLine = left + right < leastOfHighest * middle;
    const double offset = isOnLine ? 0 : offsetOf(spectrum.window, left, right);
    return {
        (static_cast<double>(line) + offset) * spectrum.resolution, middle / windowResponse(spectrum.window, offset)};
}

} // namespace

QList<SpectrumPeak> peaks(const Spectrum &spectrum, int most)
{
    const QList<double> &height = spectrum.amplitude;
    if (height.size() < 3) {
        return {};
    }
    const double highest = *std::max_element(height.cbegin(), height.cend());
    const double least = std::max(leastOverMedian * median(height), leastOfHighest * highest);
    QList<qsizetype> summits;
    for (qsizetype line = 1; line + 1 < height.size(); ++line) {
        if (height.at(line) > least && height.at(line) > height.at(line - 1)
            && height.at(line) >= height.at(line + 1)) {
            summits.append(line);
        }
    }
    std::sort(summits.begin(), summits.end(), [&height](qsizetype a, qsizetype b) {
        return height.at(a) > height.at(b);
    });
    QList<qsizetype> chosen;
    QList<SpectrumPeak> found;
    for (const qsizetype line : summits) {
        const bool isPartOfStronger = std::any_of(chosen.cbegin(), chosen.cend(), [&](qsizetype other) {
            return std::llabs(line - other) <= mainLobe(spectrum.window);
        });
        if (found.size() < most && !isPartOfStronger) {
            chosen.append(line);
            found.append(between(spectrum, line));
        }
    }
    return found;
}

} // namespace gorizont
