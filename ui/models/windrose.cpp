#include "ui/models/windrose.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gorizont {

namespace windrose {

double normalized(double degrees)
{
    const double rest = std::fmod(degrees, 360.0);
    const double positive = rest < 0 ? rest + 360.0 : rest;
    return positive < 360.0 ? positive : 0.0; // −1e-20 + 360 is 360
}

int sectorOf(double degrees)
{
    return static_cast<int>(normalized(degrees + sectorWidth / 2) / sectorWidth) % sectorCount;
}

int classOf(double speed)
{
    const auto above = std::upper_bound(classFloors.begin(), classFloors.end(), speed);
    return static_cast<int>(above - classFloors.begin()) - 1;
}

} // namespace windrose

std::optional<WindSample> WindSample::of(const Weather &weather)
{
    const WeatherParameter *speed = weather.find(weathercode::windSpeed);
    if (!speed || !speed->mean || !std::isfinite(*speed->mean) || *speed->mean < 0) {
        return {};
    }
    WindSample sample;
    sample.speed = *speed->mean;
    sample.gust =
        std::max({sample.speed, speed->instant.value_or(0), speed->maximum.value_or(0), speed->maxPeriod.value_or(0)});
    const WeatherParameter *direction = weather.find(weathercode::windDirection);
    if (direction && direction->mean && std::isfinite(*direction->mean)) {
        sample.direction = direction->mean;
    }
    return sample;
}

void WindCounts::add(const WindSample &sample)
{
    const int speedClass = windrose::classOf(sample.speed);
    if (speedClass < 0) {
        ++calm;
    } else if (!sample.direction) {
        ++undirected;
    } else {
        const auto sector = static_cast<std::size_t>(windrose::sectorOf(*sample.direction));
        ++cells[sector][static_cast<std::size_t>(speedClass)];
    }
    speedSum += sample.speed;
    fastest = std::max(fastest, sample.gust);
}

void WindCounts::add(const WindCounts &other)
{
    for (std::size_t sector = 0; sector < cells.size(); ++sector) {
        std::ranges::transform(cells[sector], other.cells[sector], cells[sector].begin(), std::plus());
    }
    calm += other.calm;
    undirected += other.undirected;
    speedSum += other.speedSum;
    fastest = std::max(fastest, other.fastest);
}

quint32 WindCounts::inSector(int sector) const
{
    const auto &classes = cells[static_cast<std::size_t>(sector)];
    return std::accumulate(classes.begin(), classes.end(), quint32(0));
}

quint32 WindCounts::total() const
{
    quint32 sum = calm + undirected;
    for (int sector = 0; sector < windrose::sectorCount; ++sector) {
        sum += inSector(sector);
    }
    return sum;
}

double WindCounts::share(quint32 count) const
{
    const quint32 all = total();
    return all == 0 ? 0 : double(count) / all;
}

std::optional<int> WindCounts::prevailing() const
{
    int most = 0;
    for (int sector = 1; sector < windrose::sectorCount; ++sector) {
        if (inSector(sector) > inSector(most)) {
            most = sector;
        }
    }
    return inSector(most) > 0 ? std::optional(most) : std::nullopt;
}

std::optional<double> WindCounts::meanSpeed() const
{
    const quint32 all = total();
    return all == 0 ? std::nullopt : std::optional(speedSum / all);
}

void WindRecord::add(SteadyTime time, const WindSample &sample)
{
    const auto minute = std::chrono::floor<std::chrono::minutes>(time.time_since_epoch());
    if (m_minutes.empty() || m_minutes.back().start < minute) {
        m_minutes.push_back({minute, {}});
    }
    m_minutes.back().counts.add(sample);
    while (m_minutes.front().start + longest <= minute) {
        m_minutes.pop_front();
    }
}

WindCounts WindRecord::over(std::chrono::minutes span, SteadyTime now) const
{
    const auto from = std::chrono::floor<std::chrono::minutes>(now.time_since_epoch()) - span;
    WindCounts sum;
    for (auto minute = m_minutes.rbegin(); minute != m_minutes.rend() && minute->start > from; ++minute) {
        sum.add(minute->counts);
    }
    return sum;
}

} // namespace gorizont
