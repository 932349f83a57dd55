#pragma once

#include "core/station/slidingmean.h"

namespace gorizont::station {

/// 0 ≤ … < 360.
double turned(double degrees);
/// The angle between two directions, 0…180 degrees.
double angleBetween(double degrees, double other);

/// The mean of the last directions, by their sines and cosines (manual 004, section 5.3), each counting alike.
class DirectionWindow
{
public:
    /// \a length: places, 1…
    explicit DirectionWindow(qsizetype length);

    void push(std::optional<double> degrees);
    qint64 count() const { return m_sine.count(); }
    /// atan2 of the means, 0 ≤ … < 360 degrees. Empty: no directions, or they cancel each other out.
    std::optional<double> mean() const;
    /// σ of the directions, degrees, by the method of Yamartino (1984), which meteorology uses for what is averaged by components:
    /// arcsin ε · (1 + (2/√3 − 1)·ε³) with ε² = 1 − (mean sin)² − (mean cos)². 0 for equal directions, 103.9 for all of them.
    std::optional<double> deviation() const;

private:
    SlidingMean m_sine;
    SlidingMean m_cosine;
};

/// The modulus of the mean of the last wind vectors.
class VectorWindow
{
public:
    /// \a length: places, 1…
    explicit VectorWindow(qsizetype length);

    /// A vector without \a speed or direction is none.
    void push(std::optional<double> speed, std::optional<double> degrees);
    /// √((mean M·sin)² + (mean M·cos)²), in the unit of the speed. Empty: no vectors.
    std::optional<double> modulus() const;

private:
    SlidingMean m_east;
    SlidingMean m_north;
};

} // namespace gorizont::station
