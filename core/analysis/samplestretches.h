#pragma once

#include "core/values/series.h"

namespace gorizont {

/// The samples of a series as stretches without a missing one.
struct SampleStretches
{
    double rate = 0; ///< samples a second; 0: fewer than two samples
    QList<QList<double>> stretches;
    qsizetype samples() const;
};

/// The rate is the median distance of two samples; where the next is more than one and a half of it away, or a gap lies
/// between, a new stretch begins. \a series is at full rate; buckets of no valid value end a stretch too.
SampleStretches sampleStretches(const Series &series);

} // namespace gorizont
