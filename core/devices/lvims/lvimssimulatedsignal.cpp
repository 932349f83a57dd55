#include "core/devices/lvims/lvimssimulatedsignal.h"

#include <cmath>
#include <numbers>

namespace gorizont::lvims {

namespace {

constexpr double tau = 2 * std::numbers::pi;

/// A transform of a power of two, in place; written here so that the one of the program has somebody to check it.
void transform(std::vector<std::complex<double>> &x)
{
    const std::size_t n = x.size();
    if (n < 2) {
        return;
    }
    std::vector<std::complex<double>> even(n / 2);
    std::vector<std::complex<double>> odd(n / 2);
    for (std::size_t i = 0; i < n / 2; ++i) {
        even[i] = x[2 * i];
        odd[i] = x[2 * i + 1];
    }
    transform(even);
    transform(odd);
    for (std::size_t k = 0; k < n / 2; ++k) {
        const auto turned = std::polar(1.0, -tau * static_cast<double>(k) / static_cast<double>(n)) * odd[k];
        x[k] = even[k] + turned;
        x[k + n / 2] = even[k] - turned;
    }
}

} // namespace

double blackman(int index, int size)
{
    const double x = tau * index / size;
    return 0.42 - 0.5 * std::cos(x) + 0.08 * std::cos(2 * x);
}

double SimulatedSignal::acceleration(double seconds) const
{
    double sum = 0;
    for (const Tone &tone : m_tones) {
        sum += tone.amplitude * std::sin(tau * tone.frequency * seconds + tone.phase);
    }
    return sum;
}

double SimulatedSignal::accelerationRms() const
{
    double squares = 0;
    for (const Tone &tone : m_tones) {
        squares += tone.amplitude * tone.amplitude / 2;
    }
    return std::sqrt(squares);
}

double SimulatedSignal::velocityRms() const
{
    double squares = 0;
    for (const Tone &tone : m_tones) {
        squares += std::pow(tone.amplitude / (tau * tone.frequency), 2) / 2;
    }
    return std::sqrt(squares);
}

double SimulatedSignal::displacementRms() const
{
    constexpr double micrometres = 1000; ///< in a millimetre
    double squares = 0;
    for (const Tone &tone : m_tones) {
        squares += std::pow(micrometres * tone.amplitude / std::pow(tau * tone.frequency, 2), 2) / 2;
    }
    return std::sqrt(squares);
}

std::vector<std::complex<double>> SimulatedSignal::spectrum(double seconds, double rate, int size, double scale) const
{
    SimulatedSignal held(QList<Tone>{});
    for (const Tone &tone : m_tones) {
        if (tone.frequency < rate / 2) {
            held.m_tones.append(tone);
        }
    }
    std::vector<std::complex<double>> samples(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        samples[static_cast<std::size_t>(i)] = held.acceleration(seconds + i / rate) / scale * blackman(i, size);
    }
    transform(samples);
    samples.resize(samples.size() / 2);
    return samples;
}

} // namespace gorizont::lvims
