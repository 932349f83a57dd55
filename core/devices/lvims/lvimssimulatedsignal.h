#pragma once

#include <QList>

#include <chrono>
#include <complex>
#include <vector>

namespace gorizont::lvims {

struct Tone
{
    double frequency = 0; ///< Hz
    double amplitude = 0; ///< mm/s²
    double phase = 0; ///< radians
};

/// What a simulated sensor of acceleration feels: a mixture of tones, and what its module makes of it. Pure: the same time gives
/// the same value.
class SimulatedSignal
{
public:
    using Time = std::chrono::microseconds; ///< since the start of the simulation

    explicit SimulatedSignal(QList<Tone> tones)
        : m_tones(std::move(tones))
    {
    }

    double acceleration(double seconds) const; ///< mm/s²
    double accelerationRms() const; ///< mm/s²
    double velocityRms() const; ///< mm/s
    double displacementRms() const; ///< µm

    /// The spectrum of \a size samples (a power of two) at \a rate Hz, taken through a window of Blackman (0.42, 0.5, 0.08):
    /// size / 2 bins. Tones that \a rate cannot hold are filtered out before. \a scale: mm/s² of a code.
    std::vector<std::complex<double>> spectrum(double seconds, double rate, int size, double scale) const;

    const QList<Tone> &tones() const { return m_tones; }

private:
    QList<Tone> m_tones;
};

double blackman(int index, int size);

} // namespace gorizont::lvims
