#pragma once

#include "core/values/timing.h"
#include "core/values/weather.h"

#include <array>
#include <deque>
#include <optional>

namespace gorizont {

/// How winds are sorted: sixteen rumbs from the north, clockwise, and classes of speed. Pure.
namespace windrose {

constexpr int sectorCount = 16;
constexpr double sectorWidth = 360.0 / sectorCount; ///< degrees; the first one lies around the north
constexpr std::array classFloors{0.5, 2.0,  4.0,
                                 7.0, 11.0, 15.0}; ///< m/s; below the first it is calm, the last has no end
constexpr int classCount = static_cast<int>(classFloors.size());
constexpr double calm = classFloors.front(); ///< m/s

double normalized(double degrees); ///< 0 ≤ result < 360
int sectorOf(double degrees); ///< 0…15; 0: north, 4: east
int classOf(double speed); ///< \a speed in m/s; −1: calm

} // namespace windrose

/// What a station says of the wind at one moment.
struct WindSample
{
    std::optional<double> direction; ///< degrees from which it blows; empty: not valid
    double speed = 0; ///< m/s
    double gust = 0; ///< m/s, the largest value that came with it; never below speed

    /// By the means, which every data command brings: of a station without a valid speed nothing is known. Empty: that.
    static std::optional<WindSample> of(const Weather &weather);
    bool operator==(const WindSample &) const = default;
};

/// How often the wind blew from where and how strongly. Every reading counts once.
struct WindCounts
{
    std::array<std::array<quint32, windrose::classCount>, windrose::sectorCount> cells{}; ///< sector, class
    quint32 calm = 0; ///< slower than the first class: the direction does not count
    quint32 undirected = 0; ///< faster, but without a valid direction
    double speedSum = 0; ///< m/s
    double fastest = 0; ///< m/s, of the gusts

    void add(const WindSample &sample);
    void add(const WindCounts &other);

    quint32 total() const;
    quint32 inSector(int sector) const;
    double share(quint32 count) const; ///< of total(), 0…1; 0 without readings
    std::optional<int> prevailing() const; ///< the sector with most readings, the first of equals; empty: none has any
    std::optional<double> meanSpeed() const; ///< m/s
    bool operator==(const WindCounts &) const = default;
};

/// The winds of the last day, minute by minute. Pure: who asks says what time it is.
class WindRecord
{
public:
    static constexpr std::chrono::hours longest{24};

    /// Times come in ascending order; an earlier one counts in the last minute that is known.
    void add(SteadyTime time, const WindSample &sample);
    /// What came within \a span before \a now, to a minute.
    WindCounts over(std::chrono::minutes span, SteadyTime now) const;

private:
    struct Minute
    {
        std::chrono::minutes start; ///< on the steady clock
        WindCounts counts;
    };
    std::deque<Minute> m_minutes;
};

} // namespace gorizont
