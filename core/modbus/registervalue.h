#pragma once

#include <QtGlobal>

#include <cmath>
#include <limits>

namespace gorizont {

/// A physical value as the integer of a register: \a value in units of 1/\a scale, rounded half away from zero,
/// saturated at the limits of T, and 0 for what is not a number (spec/gorizont.md, section 6).
template <typename T> T registerValue(double value, double scale)
{
    // A decimal half that binary arithmetic leaves a few ulps short (1.005 × 100 = 100.49999999999999) is a half too.
    constexpr double nudge = 1 + 8 * std::numeric_limits<double>::epsilon();
    const double rounded = std::round(value * scale * nudge);
    if (std::isnan(rounded)) {
        return 0;
    }
    if (rounded <= std::numeric_limits<T>::min()) {
        return std::numeric_limits<T>::min();
    }
    if (rounded >= std::numeric_limits<T>::max()) {
        return std::numeric_limits<T>::max();
    }
    return static_cast<T>(rounded);
}

/// Two's complement, as manual 000, section 10.3, transmits a short.
inline quint16 shortRegister(double value, double scale)
{
    return static_cast<quint16>(registerValue<qint16>(value, scale));
}

inline quint16 wordRegister(double value, double scale)
{
    return registerValue<quint16>(value, scale);
}

} // namespace gorizont
