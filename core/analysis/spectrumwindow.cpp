#include "core/analysis/spectrumwindow.h"

#include <cmath>
#include <numbers>

namespace gorizont {

namespace {

constexpr double pi = std::numbers::pi;

QList<double> coefficients(SpectrumWindow window)
{
    switch (window) {
    case SpectrumWindow::Rectangular: break;
    case SpectrumWindow::Hann: return {0.5, 0.5};
    case SpectrumWindow::Hamming: return {0.54, 0.46};
    case SpectrumWindow::Blackman: return {0.42, 0.5, 0.08};
    case SpectrumWindow::BlackmanHarris: return {0.35875, 0.48829, 0.14128, 0.01168}; // Harris 1978, four terms
    }
    return {1};
}

double sinc(double x)
{
    return x == 0 ? 1 : std::sin(pi * x) / (pi * x);
}

} // namespace

QList<double> windowWeights(SpectrumWindow window, qsizetype length)
{
    const QList<double> terms = coefficients(window);
    QList<double> weights(length);
    for (qsizetype n = 0; n < length; ++n) {
        double weight = 0;
        for (qsizetype j = 0; j < terms.size(); ++j) {
            const double angle = 2 * pi * static_cast<double>(j * n) / static_cast<double>(length);
            weight += (j % 2 == 0 ? 1 : -1) * terms.at(j) * std::cos(angle);
        }
        weights[n] = weight;
    }
    return weights;
}

double windowResponse(SpectrumWindow window, double offset)
{
    const QList<double> terms = coefficients(window);
    double response = terms.first() * sinc(offset);
    for (qsizetype j = 1; j < terms.size(); ++j) {
        const auto shift = static_cast<double>(j);
        response += terms.at(j) / 2 * (sinc(offset - shift) + sinc(offset + shift));
    }
    return std::abs(response) / terms.first();
}

int mainLobe(SpectrumWindow window)
{
    return static_cast<int>(coefficients(window).size());
}

} // namespace gorizont
