#pragma once

#include "core/values/quantity.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gorizont {

/// One quantity of a reading, as it is kept; empty: it brought none, or not a valid one.
struct KeptValue
{
    Quantity quantity = Quantity::TiltX;
    std::optional<double> value;
    bool operator==(const KeptValue &) const = default;
};

/// What the archive keeps of an answer of a sensor.
struct KeptReading
{
    int number = 0; ///< N
    UtcTime time;
    QList<KeptValue> values; ///< of every quantity that the sensor measures, in ascending order
    bool operator==(const KeptReading &) const = default;

    bool hasValue() const
    {
        return std::any_of(values.begin(), values.end(), [](const KeptValue &kept) { return kept.value.has_value(); });
    }
};

/// What has far more digits than meaning is rounded: displacements, which are computed, to a micrometre; the weather, of which stations
/// show tenths, to a hundredth. All others are kept as they are.
inline std::optional<double> keptValue(const std::optional<double> &value, Quantity quantity)
{
    const bool isComputed = quantity == Quantity::DisplacementX || quantity == Quantity::DisplacementY;
    const bool isWeather = quantity >= Quantity::WindSpeed && quantity <= Quantity::Humidity;
    const double parts = isComputed ? 1000 : 100;
    return value && (isComputed || isWeather) ? std::round(*value * parts) / parts : value;
}

/// \a quantities: those that the sensor measures; samples are not among the values of a reading.
inline KeptReading keptReading(const Reading &reading, const QList<Quantity> &quantities)
{
    KeptReading kept{reading.number, reading.time, {}};
    kept.values.reserve(quantities.size());
    for (const Quantity quantity : quantities) {
        if (quantity != Quantity::SampleX && quantity != Quantity::SampleY) {
            kept.values.append({quantity, keptValue(valueOf(reading, quantity), quantity)});
        }
    }
    return kept;
}

} // namespace gorizont
