#pragma once

#include "core/archive/chunkkind.h"
#include "core/archive/readingchunk.h"
#include "core/values/series.h"

namespace gorizont {

/// Buckets of one curve, ascending, no two of the same time.
using Buckets = QList<SeriesBucket>;

constexpr ChunkKind rollupKinds[] = {ChunkKind::Minutes, ChunkKind::Hours, ChunkKind::Days};

/// Length of a bucket of \a kind; buckets begin at whole multiples of it since 1970, UTC.
constexpr std::chrono::microseconds stepOf(ChunkKind kind)
{
    switch (kind) {
    case ChunkKind::Minutes: return std::chrono::minutes(1);
    case ChunkKind::Hours: return std::chrono::hours(1);
    case ChunkKind::Days: return std::chrono::hours(24);
    case ChunkKind::FullRate:
    case ChunkKind::Samples: break;
    }
    return {};
}

/// How long a stretch one row of the archive holds: 360, 240 or 360 buckets.
constexpr std::chrono::microseconds stretchOf(ChunkKind kind)
{
    return stepOf(kind) * (kind == ChunkKind::Hours ? 240 : 360);
}

/// The multiple of \a step at or before \a time.
inline UtcTime floored(UtcTime time, std::chrono::microseconds step)
{
    const auto since = time.time_since_epoch();
    const auto rest = since % step;
    return time - (rest.count() < 0 ? rest + step : rest);
}

/// What \a column says in each \a step; times need not ascend.
Buckets bucketsOf(const std::vector<UtcTime> &times, const ValueColumn &column, std::chrono::microseconds step);

/// \a buckets joined to a longer \a step, a multiple of theirs.
Buckets coarsened(const Buckets &buckets, std::chrono::microseconds step);

/// Both together; where both have a bucket of one time the two are joined.
Buckets merged(const Buckets &a, const Buckets &b);

} // namespace gorizont
