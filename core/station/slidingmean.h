#pragma once

#include <QtGlobal>

#include <optional>
#include <vector>

namespace gorizont::station {

/// Mean and spread of values that come and go. The sums are of distances from one of the values, so that many values far from 0 and
/// close to each other lose nothing, and the mean of equal values is the value.
class Moments
{
public:
    void add(double value);
    void remove(double value); ///< one that was added

    qint64 count() const { return m_count; }
    std::optional<double> mean() const; ///< empty: no values
    /// σ of the values themselves, divided by their number, not by one less. Empty: no values.
    std::optional<double> deviation() const;

private:
    qint64 m_count = 0;
    double m_origin = 0;
    double m_sum = 0;
    double m_squares = 0;
};

/// Mean and σ of the last values, a fixed number of places of which some may be empty. The cost of a value does not depend on the
/// number of places: what leaves is taken off the sums. So that the rounding of that never adds up, a second pair of
/// sums only grows, and takes over each time that it has seen as many values as there are places.
class SlidingMean
{
public:
    /// \a length: places, 1…
    explicit SlidingMean(qsizetype length);

    void push(std::optional<double> value);

    qsizetype length() const { return static_cast<qsizetype>(m_places.size()); }
    qint64 count() const { return m_sliding.count(); } ///< of places that hold a value
    std::optional<double> mean() const { return m_sliding.mean(); }
    std::optional<double> deviation() const { return m_sliding.deviation(); }

private:
    std::vector<double> m_places; ///< a ring; NaN: empty
    std::size_t m_next = 0;
    Moments m_sliding;
    Moments m_growing; ///< of the places before m_next
};

} // namespace gorizont::station
