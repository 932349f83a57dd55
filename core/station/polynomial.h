#pragma once

#include <QList>

#include <optional>

namespace gorizont::station {

constexpr qsizetype mostCoefficients = 10; ///< degree 9 (manual 004, section 3.2)

/// c0 + c1·x + c2·x² + …; 0 without coefficients.
double polynomial(const QList<double> &coefficients, double x);

/// How a measured value becomes a physical one (manual 004, section 3.2, "Коэффициенты полинома").
struct Conversion
{
    double origin = 0; ///< x0, in the unit of what is measured
    QList<double> coefficients; ///< c0 … c9, 1…10 of them

    /// c0 alone: the parameter has three values only, by the threshold c0.
    bool isThreshold() const { return coefficients.size() == 1; }
    bool operator==(const Conversion &) const = default;
};

/// Between which values a parameter lies, in its unit; empty: no limit.
struct Limits
{
    std::optional<double> left;
    std::optional<double> right;
    bool contains(double value) const { return (!left || value >= *left) && (!right || value <= *right); }
    bool operator==(const Limits &) const = default;
};

/// Σ ci·(x−x0)^i. With c0 alone: the right limit from x ≥ c0+error, the left one up to x ≤ c0−error, between them their mean; a
/// limit that is not given counts as 0 (left) and 1 (right).
double converted(const Conversion &conversion, const Limits &limits, double error, double x);

} // namespace gorizont::station
