#include "core/station/sources/signal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gorizont::station {

namespace {

constexpr double fullCircle = 360; ///< degrees
constexpr double fullTurn = 2 * std::numbers::pi;

/// A number from 0 to 1 that looks random and depends on \a seed only (the finalizer of splitmix64).
double scattered(quint64 seed)
{
    quint64 z = seed + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1.0p-53;
}

/// Normally distributed, mean 0, deviation 1.
double gaussian(quint64 seed)
{
    const double radius = std::sqrt(-2 * std::log(1 - scattered(2 * seed)));
    return radius * std::cos(fullTurn * scattered(2 * seed + 1));
}

bool isInTail(double time, double period, double extent)
{
    return std::fmod(time, period) >= period - extent;
}

} // namespace

double Signal::value(std::chrono::duration<double> time, quint64 step, quint64 channel) const
{
    const double t = time.count();
    switch (kind) {
    case Kind::Constant: return level;
    case Kind::Sine: return level + size * std::sin(fullTurn * (t / period + extent / fullCircle));
    case Kind::Noise: return level + size * gaussian(step * 128 + channel);
    case Kind::Drop: return isInTail(t, period, extent) ? level - size : level;
    case Kind::Square: return isInTail(t, period, extent) ? level + size : level;
    }
    return level;
}

double Vane::frequencyAt(std::chrono::duration<double> time) const
{
    return std::max(0.0, speed + gust * std::sin(fullTurn * time.count() / period));
}

/// The swing is slower than the gusts, so that the two do not go together.
double Vane::phaseAt(std::chrono::duration<double> time) const
{
    const double angle = direction + swing * std::sin(fullTurn * time.count() / (period * std::numbers::phi));
    const double turned = std::fmod(angle, fullCircle);
    return turned < 0 ? turned + fullCircle : turned;
}

} // namespace gorizont::station
