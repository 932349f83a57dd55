#pragma once

#include "core/values/series.h"

#include <optional>

namespace gorizont {

/// What a curve did between two moments, in the unit of its quantity.
struct SeriesStatistics
{
    double first = 0;
    double last = 0;
    double minimum = 0;
    double maximum = 0;
    double mean = 0; ///< of all valid readings
    double slope = 0; ///< a day, of the straight line of least squares; 0: all at one moment
    double completeness = 0; ///< 0 … 1, the share of the time that lies in no gap
    quint64 readings = 0;
    quint64 valid = 0;

    double difference() const { return last - first; }
    double slopeAnHour() const { return slope / 24; }
    bool operator==(const SeriesStatistics &) const = default;
};

/// Of what begins in from ≤ t < to. Empty: no valid value there.
std::optional<SeriesStatistics> statistics(const Series &series, UtcTime from, UtcTime to);

/// The share, 0 … 1, of from ≤ t < to that lies in none of \a gaps, which stand in ascending time and may overlap.
double completeness(const QList<TimeSpan> &gaps, UtcTime from, UtcTime to);

/// The value nearest to \a time. Empty: a gap is there, or the series does not reach so far.
std::optional<double> valueAt(const Series &series, UtcTime time);

} // namespace gorizont
