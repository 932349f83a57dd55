#pragma once

#include <QChar>
#include <QtGlobal>

#include <chrono>

namespace gorizont::mk14 {

/// The weather over a simulated site: days that warm and cool, wind that turns and blows in gusts, showers. A pure function of seed
/// and time: the same question always gets the same answer.
class SimulatedWeather
{
public:
    using Time = std::chrono::microseconds; ///< since the start of the simulation

    explicit SimulatedWeather(quint64 seed)
        : m_seed(seed)
    {
    }

    /// What a station measures at \a at for a parameter with \a code: U V, T °C, P mm Hg, H %, A degrees (0 ≤ A < 360), M and W m/s; 1 for
    /// a code that is not known. \a number makes parameters of one code differ.
    double value(QChar code, int number, Time at) const;

    static constexpr std::chrono::seconds showerPeriod{600};
    static constexpr std::chrono::seconds showerStart{240}; ///< into the period
    static constexpr std::chrono::seconds showerEnd{420};

private:
    double noise(Time at, int channel) const;
    double speed(Time at) const;

    quint64 m_seed;
};

} // namespace gorizont::mk14
