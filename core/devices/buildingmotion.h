#pragma once

#include <QtGlobal>

#include <chrono>

namespace gorizont {

/// How a building moves, for the simulators: slow thermal tilt, sway at its natural frequency with damping, noise, and
/// a sensor that warms up. A pure function of seed, sensor and time: the same question always gets the same answer.
class BuildingMotion
{
public:
    using Time = std::chrono::microseconds; ///< since the start of the simulation

    /// \a number makes sensors of one building differ; the building itself depends on \a seed only.
    BuildingMotion(quint64 seed, int number);

    double tiltX(Time at) const; ///< arc-seconds, sway included
    double tiltY(Time at) const; ///< arc-seconds, sway included
    double accelerationX(Time at) const; ///< mm/s²
    double accelerationY(Time at) const; ///< mm/s²
    double temperature(Time at) const; ///< °C, of the sensor's inside
    double heaterPower(Time at) const; ///< %, 0…100
    double fanFrequency(Time at) const; ///< 1/s

private:
    double sway(Time at, int axis) const;
    double noise(Time at, int channel) const;

    quint64 m_seed;
    int m_number;
    double m_height; ///< of the sensor, share of the building: how much of the sway it feels
    double m_frequency[2]; ///< Hz
    double m_phase[2]; ///< radians
    double m_offset[2]; ///< arc-seconds
    double m_thermal[2]; ///< arc-seconds, amplitude of a day
};

} // namespace gorizont
