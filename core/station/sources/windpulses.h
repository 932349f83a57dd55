#pragma once

#include <chrono>
#include <deque>
#include <optional>

namespace gorizont::station {

/// What a wind sensor says before any conversion.
struct WindRaw
{
    std::optional<double> frequency; ///< Hz, of the reference series: grows with the speed
    std::optional<double> phase; ///< degrees, 0 … 360: how far the main series is behind the reference
    bool operator==(const WindRaw &) const = default;
};

/// Two series of pulses of a wind sensor (manual 004, section 5.3): the reference series has the speed in its frequency, the main
/// one the direction in its phase behind the reference. Pure: the times of the edges are given and must not go back.
class WindPulses
{
public:
    using Time = std::chrono::microseconds;

    struct Settings
    {
        Time shortest{0}; ///< a pulse that comes sooner after the one before is a disturbance (ACK.PSE)
        Time averaging{std::chrono::seconds(1)}; ///< over the pulses of how long, > 0 (ACK.PSE, in ticks)
        int multiplier = 100; ///< 1 … 1000: values are kept in steps of 1/multiplier (ACK.INI)
    };

    explicit WindPulses(const Settings &settings)
        : m_settings(settings)
    {
    }

    void addReference(Time at);
    void addMain(Time at);

    /// Over the last Settings::averaging before \a now. Without a pulse the frequency is 0 and there is no phase.
    WindRaw measure(Time now);

private:
    struct Phase
    {
        Time at;
        double turn; ///< 0 … 1
    };

    bool isDisturbance(std::optional<Time> &last, Time at) const;
    void forget(Time before);
    double rounded(double value) const;

    Settings m_settings;
    std::deque<Time> m_reference; ///< those of the interval and the one before it
    std::deque<Phase> m_phases;
    std::optional<Time> m_lastReference;
    std::optional<Time> m_lastMain;
    std::optional<Time> m_period; ///< between the last two pulses of the reference
};

} // namespace gorizont::station
