#include "core/archive/archivequery.h"

namespace gorizont {

/// Whole parts of the next longer unit only, so that buckets lie where a clock has its marks.
SeriesStep stepFor(std::chrono::microseconds span, int width)
{
    using namespace std::chrono_literals;
    static constexpr std::pair<ChunkKind, std::chrono::microseconds> steps[]{
        {ChunkKind::Days, 24h},      {ChunkKind::Hours, 12h},     {ChunkKind::Hours, 6h},
        {ChunkKind::Hours, 4h},      {ChunkKind::Hours, 3h},      {ChunkKind::Hours, 2h},
        {ChunkKind::Hours, 1h},      {ChunkKind::Minutes, 30min}, {ChunkKind::Minutes, 20min},
        {ChunkKind::Minutes, 15min}, {ChunkKind::Minutes, 10min}, {ChunkKind::Minutes, 5min},
        {ChunkKind::Minutes, 4min},  {ChunkKind::Minutes, 3min},  {ChunkKind::Minutes, 2min},
        {ChunkKind::Minutes, 1min},  {ChunkKind::FullRate, 30s},  {ChunkKind::FullRate, 20s},
        {ChunkKind::FullRate, 15s},  {ChunkKind::FullRate, 10s},  {ChunkKind::FullRate, 5s}};
    if (width <= 0) {
        return {};
    }
    for (const auto &[kind, step] : steps) {
        if (span / step >= width) {
            return {kind, step};
        }
    }
    return {};
}

} // namespace gorizont
