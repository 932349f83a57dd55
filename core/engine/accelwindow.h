#pragma once

#include "core/values/geometry.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"

#include <deque>
#include <optional>
#include <vector>

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

    /// Blocks come in the order of their samples. A gap between two of them clears nothing; samples older than the
    /// length before the end of this block fall out. A block without samples or without a rate is ignored.
    void add(const SampleBlock &block);
    void clear();

    /// Empty: not ready.
    std::optional<AccelStatistics> statistics() const;

private:
    /// The samples of one block and what the statistics need of them, so that they are gone through once.
    struct Part
    {
        UtcTime start; ///< of the first sample
        std::chrono::microseconds period;
        std::vector<Tilt> vectors; ///< mm/s², axes of the site
        Tilt largest; ///< mm/s²
        double sumXX = 0; ///< (mm/s²)²
        double sumYY = 0;

        UtcTime end() const { return start + static_cast<qint64>(vectors.size()) * period; }
        void summarize();
    };

    void moveBefore(UtcTime start);
    void dropBefore(UtcTime start);

    AxisTransform m_transform;
    std::deque<Part> m_parts;
};

} // namespace gorizont
