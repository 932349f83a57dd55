#include "core/devices/buildingmotion.h"

#include <cmath>
#include <numbers>

namespace gorizont {

namespace {

constexpr double tau = 2 * std::numbers::pi;
constexpr double dayInSeconds = 86400;
constexpr double damping = 0.02; ///< of critical
constexpr double gustPeriod = 47; ///< seconds between two gusts that set the building swinging
constexpr double swayAmplitude = 12; ///< mm/s² right after a gust
constexpr double tiltPerAcceleration = 0.35; ///< arc-seconds of rotation for each mm/s² of sway
constexpr double ambient = 18; ///< °C
constexpr double selfHeating = 8; ///< °C above ambient once warm
constexpr double warmingTime = 600; ///< seconds

double seconds(BuildingMotion::Time at)
{
    return std::chrono::duration<double>(at).count();
}

/// SplitMix64: a good hash of an integer, so that noise needs no state.
quint64 mix(quint64 z)
{
    z += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
}

/// 0 ≤ value < 1
double uniform(quint64 z)
{
    return static_cast<double>(mix(z) >> 11) * 0x1.0p-53;
}

} // namespace

BuildingMotion::BuildingMotion(quint64 seed, int number)
    : m_seed(seed)
    , m_number(number)
{
    const quint64 own = mix(seed) ^ (static_cast<quint64>(number) << 32);
    m_height = 0.3 + 0.7 * uniform(own + 40);
    for (int axis = 0; axis < 2; ++axis) {
        const auto salt = static_cast<quint64>(axis);
        m_frequency[axis] = 0.25 + 0.15 * static_cast<double>(axis) + 0.1 * uniform(seed + salt);
        m_phase[axis] = tau * uniform(seed + 10 + salt);
        m_offset[axis] = 600 * (uniform(own + 20 + salt) - 0.5);
        m_thermal[axis] = 15 + 20 * uniform(own + 30 + salt);
    }
}

/// Gusts at equal intervals, each starting a damped oscillation of random strength.
double BuildingMotion::sway(Time at, int axis) const
{
    const double t = seconds(at);
    const double gust = std::floor(t / gustPeriod);
    const double since = t - gust * gustPeriod;
    const double strength = 0.3 + 0.7 * uniform(m_seed ^ (static_cast<quint64>(gust) * 4 + static_cast<quint64>(axis)));
    const double omega = tau * m_frequency[axis];
    return m_height * strength * std::exp(-damping * omega * since) * std::sin(omega * since + m_phase[axis]);
}

/// Roughly normal with a deviation of 1: the sum of four uniforms, one draw a millisecond and channel.
double BuildingMotion::noise(Time at, int channel) const
{
    const auto tick = static_cast<quint64>(at.count() / 1000);
    const quint64 base = mix(m_seed + static_cast<quint64>(m_number)) + tick * 16 + static_cast<quint64>(channel) * 4;
    const double sum = uniform(base) + uniform(base + 1) + uniform(base + 2) + uniform(base + 3);
    return (sum - 2) * std::sqrt(3.0);
}

double BuildingMotion::tiltX(Time at) const
{
    return m_offset[0] + m_thermal[0] * std::sin(tau * seconds(at) / dayInSeconds)
        + tiltPerAcceleration * swayAmplitude * sway(at, 0) + 0.15 * noise(at, 0);
}

double BuildingMotion::tiltY(Time at) const
{
    return m_offset[1] + m_thermal[1] * std::cos(tau * seconds(at) / dayInSeconds)
        + tiltPerAcceleration * swayAmplitude * sway(at, 1) + 0.15 * noise(at, 1);
}

double BuildingMotion::accelerationX(Time at) const
{
    return swayAmplitude * sway(at, 0) + 0.05 * noise(at, 2);
}

double BuildingMotion::accelerationY(Time at) const
{
    return swayAmplitude * sway(at, 1) + 0.05 * noise(at, 3);
}

double BuildingMotion::temperature(Time at) const
{
    const double t = seconds(at);
    return ambient + 4 * std::sin(tau * t / dayInSeconds) + selfHeating * (1 - std::exp(-t / warmingTime))
        + 0.01 * noise(at, 4);
}

double BuildingMotion::heaterPower(Time at) const
{
    return 5 + 95 * std::exp(-seconds(at) / warmingTime);
}

double BuildingMotion::fanFrequency(Time at) const
{
    return 42 + 0.2 * noise(at, 5);
}

} // namespace gorizont
