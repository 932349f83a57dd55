#include "core/station/wind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gorizont::station {

namespace {

constexpr double degree = std::numbers::pi / 180;

} // namespace

double turned(double degrees)
{
    const double rest = std::fmod(degrees, 360);
    const double positive = rest < 0 ? rest + 360 : rest;
    return positive < 360 ? positive : 0; // a very small negative angle rounds up to 360
}

double angleBetween(double degrees, double other)
{
    const double angle = turned(degrees - other);
    return std::min(angle, 360 - angle);
}

DirectionWindow::DirectionWindow(qsizetype length)
    : m_sine(length)
    , m_cosine(length)
{
}

void DirectionWindow::push(std::optional<double> degrees)
{
    m_sine.push(degrees ? std::optional(std::sin(*degrees * degree)) : std::nullopt);
    m_cosine.push(degrees ? std::optional(std::cos(*degrees * degree)) : std::nullopt);
}

std::optional<double> DirectionWindow::mean() const
{
    const auto sine = m_sine.mean();
    const auto cosine = m_cosine.mean();
    constexpr double nothing = 1e-9; // of 1: what rounding leaves of directions that cancel out
    if (!sine || !cosine || std::hypot(*sine, *cosine) < nothing) {
        return {};
    }
    return turned(std::atan2(*sine, *cosine) / degree);
}

std::optional<double> DirectionWindow::deviation() const
{
    const auto sine = m_sine.mean();
    const auto cosine = m_cosine.mean();
    if (!sine || !cosine) {
        return {};
    }
    const double spread = std::sqrt(std::clamp(1 - *sine * *sine - *cosine * *cosine, 0.0, 1.0));
    constexpr double yamartino = 2 * std::numbers::inv_sqrt3 - 1;
    return std::asin(spread) * (1 + yamartino * spread * spread * spread) / degree;
}

VectorWindow::VectorWindow(qsizetype length)
    : m_east(length)
    , m_north(length)
{
}

void VectorWindow::push(std::optional<double> speed, std::optional<double> degrees)
{
    const bool isVector = speed && degrees;
    m_east.push(isVector ? std::optional(*speed * std::sin(*degrees * degree)) : std::nullopt);
    m_north.push(isVector ? std::optional(*speed * std::cos(*degrees * degree)) : std::nullopt);
}

std::optional<double> VectorWindow::modulus() const
{
    const auto east = m_east.mean();
    const auto north = m_north.mean();
    return east && north ? std::optional(std::hypot(*east, *north)) : std::nullopt;
}

} // namespace gorizont::station
