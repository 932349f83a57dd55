#include "core/devices/mk14/mk14simulatedweather.h"

#include "core/values/weather.h"

#include <cmath>
#include <numbers>

namespace gorizont::mk14 {

namespace {

using namespace std::chrono_literals;

double seconds(SimulatedWeather::Time time)
{
    return std::chrono::duration<double>(time).count();
}

double wave(SimulatedWeather::Time at, std::chrono::seconds period, double phase)
{
    return std::sin(2 * std::numbers::pi * (seconds(at) / seconds(period) + phase));
}

} // namespace

/// From −1 to 1, another one each second.
double SimulatedWeather::noise(Time at, int channel) const
{
    quint64 mixed = m_seed
        + static_cast<quint64>(std::chrono::floor<std::chrono::seconds>(at).count()) * 0x9E3779B97F4A7C15ULL
        + static_cast<quint64>(channel) * 0xBF58476D1CE4E5B9ULL;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBULL;
    mixed ^= mixed >> 31;
    return static_cast<double>(mixed >> 11) / static_cast<double>(1ULL << 52) - 1;
}

double SimulatedWeather::speed(Time at) const
{
    const double gust = std::max(0.0, wave(at, 47s, 0.1)) * std::max(0.0, wave(at, 310s, 0));
    return std::max(0.2, 4.2 + 1.1 * wave(at, 900s, 0.2) + 4.5 * gust + 0.6 * noise(at, 1));
}

double SimulatedWeather::value(QChar code, int number, Time at) const
{
    const double shift = number - 1;
    const bool isRaining = at % showerPeriod >= showerStart && at % showerPeriod < showerEnd;
    switch (code.unicode()) {
    case u'U': return 12.4 + shift + 0.05 * noise(at, 2);
    case u'T':
    case u't': return 14.5 + shift + 6 * wave(at, 24h, 0.6) - (isRaining ? 0.8 : 0) + 0.05 * noise(at, 3);
    case u'P': return 748.5 + 3 * wave(at, 40h, 0) + 0.05 * noise(at, 4);
    case u'H': return std::min(99.0, 62 - 15 * wave(at, 24h, 0.6) + (isRaining ? 18 : 0) + 0.3 * noise(at, 5));
    case u'A': return std::fmod(225 + 50 * wave(at, 1h, 0) + 25 * wave(at, 130s, 0.4) + 12 * noise(at, 6), 360);
    case u'M': return speed(at);
    case u'W': return speed(at) * (0.96 + 0.03 * noise(at, 7));
    default: return 1;
    }
}

} // namespace gorizont::mk14
