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

/// Displacements are computed, to far more digits than a tilt has: they are kept to a micrometre. All others as they are.
inline std::optional<double> keptValue(const std::optional<double> &value, Quantity quantity)
{
    constexpr double parts = 1000; // of a millimetre
    const bool isComputed = quantity == Quantity::DisplacementX || quantity == Quantity::DisplacementY;
    return value && isComputed ? std::round(*value * parts) / parts : value;
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
