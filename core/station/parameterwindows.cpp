#include "core/station/parameterwindows.h"

namespace gorizont::station {

RawWindows::RawWindows(const WindowSettings &settings)
    : m_mean(settings.length)
    , m_instant(settings.instant)
{
}

void RawWindows::push(std::optional<double> raw)
{
    m_mean.push(raw);
    m_instant.push(raw);
}

void RawWindows::fill(WeatherParameter &parameter) const
{
    parameter.voltage = m_mean.mean();
    parameter.voltageInstant = m_instant.mean();
}

ScalarWindows::ScalarWindows(const WindowSettings &settings)
    : m_settings(settings)
    , m_mean(settings.length)
    , m_instant(settings.instant)
    , m_extremes(settings.length)
{
}

bool ScalarWindows::push(std::optional<double> good)
{
    m_mean.push(good);
    m_instant.push(good);
    m_extremes.push(good);
    const bool isMaximum = good && (!m_periodMaximum || *good > *m_periodMaximum);
    if (isMaximum) {
        m_periodMaximum = good;
    }
    return isMaximum;
}

void ScalarWindows::fill(WeatherParameter &parameter) const
{
    const auto count = static_cast<double>(m_mean.count());
    const bool isMeanGood = !m_settings.isInstantOnly && count >= 1 && count > m_settings.neededGood;
    const auto whenGood = [isMeanGood](std::optional<double> value) { return isMeanGood ? value : std::nullopt; };
    parameter.mean = whenGood(m_mean.mean());
    parameter.instant = m_instant.mean();
    parameter.minimum = whenGood(m_extremes.minimum());
    parameter.maximum = whenGood(m_extremes.maximum());
    parameter.maxPeriod = m_settings.isInstantOnly ? std::nullopt : m_periodMaximum;
    parameter.deviation = m_settings.hasDeviation ? whenGood(m_mean.deviation()) : std::nullopt;
}

DirectionWindows::DirectionWindows(const WindowSettings &settings)
    : m_hasDeviation(settings.hasDeviation)
    , m_mean(settings.length)
    , m_instant(settings.instant)
{
}

void DirectionWindows::push(std::optional<double> good)
{
    m_mean.push(good);
    m_instant.push(good);
}

void DirectionWindows::noteGust(std::optional<double> degrees)
{
    m_gust = degrees ? std::optional(turned(*degrees)) : std::nullopt;
}

void DirectionWindows::fill(WeatherParameter &parameter) const
{
    parameter.mean = m_mean.mean();
    parameter.instant = m_instant.mean();
    parameter.minimum.reset();
    parameter.maximum.reset();
    parameter.maxPeriod = m_gust;
    parameter.deviation = m_hasDeviation ? m_mean.deviation() : std::nullopt;
}

VectorWindows::VectorWindows(const WindowSettings &settings)
    : m_mean(settings.length)
    , m_instant(settings.instant)
{
}

void VectorWindows::push(std::optional<double> speed, std::optional<double> degrees)
{
    m_mean.push(speed, degrees);
    m_instant.push(speed, degrees);
}

void VectorWindows::fill(WeatherParameter &parameter) const
{
    parameter.mean = m_mean.modulus();
    parameter.instant = m_instant.modulus();
}

} // namespace gorizont::station
