#pragma once

#include <QtGlobal>

#include <chrono>

namespace gorizont::station {

/// A simulated signal as a function of the time since the start of the source. Signals of one channel add up.
struct Signal
{
    enum class Kind : quint8 {
        Constant, ///< VALUE
        Sine, ///< MEAN AMPLITUDE PERIOD [PHASE]
        Noise, ///< MEAN DEVIATION
        Drop, ///< VALUE BY EVERY FOR: VALUE, but VALUE − BY for FOR seconds at the end of every EVERY seconds
        Square, ///< LOW HIGH PERIOD FOR: HIGH for FOR seconds at the end of every PERIOD seconds
    };

    Kind kind = Kind::Constant;
    double level = 0; ///< in the unit of the channel
    double size = 0; ///< amplitude, deviation, difference
    double period = 1; ///< s
    double extent = 0; ///< s; of a sine: phase in degrees
    bool operator==(const Signal &) const = default;

    /// At \a time; \a step and \a channel make noise differ, the same ones give the same value.
    double value(std::chrono::duration<double> time, quint64 step, quint64 channel) const;
};

/// A simulated wind vane: a steady wind that gusts and swings.
struct Vane
{
    double speed = 0; ///< Hz
    double gust = 0; ///< Hz, amplitude
    double direction = 0; ///< degrees
    double swing = 0; ///< degrees, amplitude
    double period = 60; ///< s
    bool operator==(const Vane &) const = default;

    double frequencyAt(std::chrono::duration<double> time) const; ///< Hz, ≥ 0
    double phaseAt(std::chrono::duration<double> time) const; ///< degrees, 0 … 360
};

} // namespace gorizont::station
