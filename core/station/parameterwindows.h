#pragma once

#include "core/station/slidingextremes.h"
#include "core/station/slidingmean.h"
#include "core/station/wind.h"
#include "core/values/weather.h"

#include <variant>

namespace gorizont::station {

/// How the values of a parameter are averaged.
struct WindowSettings
{
    qsizetype length = 600; ///< s of the sliding mean, 1…
    qsizetype instant = 1; ///< s of the instantaneous value, 1…
    double neededGood = 0; ///< a mean needs more good values than this, and at least one
    bool hasDeviation = true; ///< σ is calculated
    bool isInstantOnly = false; ///< of a gamma sensor: no mean, minimum and maximum
};

/// What was measured, before any conversion: every second counts in which there was anything, good or not, so that one sees why a
/// parameter is bad.
class RawWindows
{
public:
    explicit RawWindows(const WindowSettings &settings);
    void push(std::optional<double> raw);
    void fill(WeatherParameter &parameter) const;

private:
    SlidingMean m_mean;
    SlidingMean m_instant;
};

/// The good values of an ordinary parameter.
class ScalarWindows
{
public:
    explicit ScalarWindows(const WindowSettings &settings);

    /// Whether the value is a new maximum since the last request.
    bool push(std::optional<double> good);
    void beginPeriod() { m_periodMaximum.reset(); }
    std::optional<double> mean() const { return m_mean.mean(); } ///< of all good values, however few
    void fill(WeatherParameter &parameter) const;

private:
    WindowSettings m_settings;
    SlidingMean m_mean;
    SlidingMean m_instant;
    SlidingExtremes m_extremes;
    std::optional<double> m_periodMaximum;
};

/// The good values of a wind direction, degrees: mean, instantaneous value and σ, whatever the number of good values; a circle has no
/// least and no greatest. Its "maximum since the last request" is the direction in which the speed was greatest.
class DirectionWindows
{
public:
    explicit DirectionWindows(const WindowSettings &settings);

    void push(std::optional<double> good);
    /// The speed has just been greater than ever since the last request; empty: where from is not known.
    void noteGust(std::optional<double> degrees);
    void beginPeriod() { m_gust.reset(); }
    std::optional<double> mean() const { return m_mean.mean(); }
    void fill(WeatherParameter &parameter) const;

private:
    bool m_hasDeviation;
    DirectionWindow m_mean;
    DirectionWindow m_instant;
    std::optional<double> m_gust;
};

/// The wind W: mean and instantaneous value.
class VectorWindows
{
public:
    explicit VectorWindows(const WindowSettings &settings);
    void push(std::optional<double> speed, std::optional<double> degrees);
    void fill(WeatherParameter &parameter) const;

private:
    VectorWindow m_mean;
    VectorWindow m_instant;
};

using ParameterWindows = std::variant<ScalarWindows, DirectionWindows, VectorWindows>;

} // namespace gorizont::station
