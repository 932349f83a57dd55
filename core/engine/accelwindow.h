#pragma once

#include "core/values/geometry.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"

#include <deque>
#include <optional>

namespace gorizont {

/// The accelerations of the last minute of one sensor in the axes of the site, and what is said of them
/// (spec/and3.md, Statistics). Pure: the time is that of the samples.
class AccelWindow
{
public:
    /// Of valid packets; at least ten of them, otherwise there are no statistics.
    static constexpr std::chrono::seconds length{60};
    static constexpr std::size_t leastBlocks = 10;

    explicit AccelWindow(const AxisTransform &transform)
        : m_transform(transform)
    {
    }

    void add(const SampleBlock &block);
    void clear();

    /// Empty: not ready.
    std::optional<AccelStatistics> statistics() const;

private:
    AxisTransform m_transform;
};

} // namespace gorizont
