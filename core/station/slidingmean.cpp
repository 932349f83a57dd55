#include "core/station/slidingmean.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gorizont::station {

namespace {

std::optional<double> finite(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

void Moments::add(double value)
{
    if (m_count == 0) {
        *this = Moments();
        m_origin = value;
    }
    const double distance = value - m_origin;
    ++m_count;
    m_sum += distance;
    m_squares += distance * distance;
}

void Moments::remove(double value)
{
    const double distance = value - m_origin;
    --m_count;
    m_sum -= distance;
    m_squares -= distance * distance;
}

std::optional<double> Moments::mean() const
{
    return m_count > 0 ? finite(m_origin + m_sum / static_cast<double>(m_count)) : std::nullopt;
}

std::optional<double> Moments::deviation() const
{
    if (m_count == 0) {
        return {};
    }
    const auto count = static_cast<double>(m_count);
    const double variance = (m_squares - m_sum * m_sum / count) / count;
    return finite(std::isnan(variance) ? variance : std::sqrt(std::max(0.0, variance)));
}

SlidingMean::SlidingMean(qsizetype length)
    : m_places(static_cast<std::size_t>(std::max<qsizetype>(1, length)), std::numeric_limits<double>::quiet_NaN())
{
}

void SlidingMean::push(std::optional<double> value)
{
    double &place = m_places[m_next];
    if (!std::isnan(place)) {
        m_sliding.remove(place);
    }
    place = value.value_or(std::numeric_limits<double>::quiet_NaN());
    if (value) {
        m_sliding.add(*value);
        m_growing.add(*value);
    }
    if (++m_next == m_places.size()) {
        m_next = 0;
        m_sliding = m_growing;
        m_growing = Moments();
    }
}

} // namespace gorizont::station
