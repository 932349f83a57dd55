#include "core/engine/accelwindow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gorizont {

namespace {

double squared(const Tilt &vector)
{
    return vector.x * vector.x + vector.y * vector.y;
}

/// 0 ≤ degrees < 360; 0 for no vector at all.
double directionOf(const Tilt &vector)
{
    if (squared(vector) == 0) {
        return 0;
    }
    const double degrees = std::atan2(vector.y, vector.x) * 180 / std::numbers::pi;
    const double turned = degrees < 0 ? degrees + 360 : degrees;
    return turned < 360 ? turned + 0.0 : 0; // + 0.0: no negative zero
}

} // namespace

void AccelWindow::add(const SampleBlock &block)
{
    const qsizetype count = std::min(block.x.size(), block.y.size());
    if (count == 0 || !(block.rate > 0)) {
        return;
    }
    Part part;
    part.start = block.start;
    part.period = std::chrono::microseconds(std::max(1LL, std::llround(1e6 / block.rate)));
    part.vectors.reserve(static_cast<std::size_t>(count));
    for (qsizetype i = 0; i < count; ++i) {
        part.vectors.push_back(m_transform(block.x.at(i) * block.scale, block.y.at(i) * block.scale));
    }
    part.summarize();
    if (!m_parts.empty() && (block.followsPrevious || block.start < m_parts.back().end())) {
        moveBefore(block.start);
    }
    m_parts.push_back(std::move(part));
    dropBefore(m_parts.back().end() - length);
}

void AccelWindow::clear()
{
    m_parts.clear();
}

/// The host's clock was set: a block follows the one before although its time says otherwise, or begins before that has
/// ended. What is kept gets the new time, so that it neither stays for hours nor falls out at once.
void AccelWindow::moveBefore(UtcTime start)
{
    const auto step = start - m_parts.back().end();
    for (Part &part : m_parts) {
        part.start += step;
    }
}

/// Whole parts go as they are; of the oldest one left only what is too old.
void AccelWindow::dropBefore(UtcTime start)
{
    while (m_parts.front().end() <= start) {
        m_parts.pop_front();
    }
    Part &oldest = m_parts.front();
    if (oldest.start < start) {
        const auto tooOld = (start - oldest.start + oldest.period - std::chrono::microseconds(1)) / oldest.period;
        oldest.vectors.erase(oldest.vectors.begin(), oldest.vectors.begin() + tooOld);
        oldest.start += tooOld * oldest.period;
        oldest.summarize();
    }
}

void AccelWindow::Part::summarize()
{
    largest = {};
    sumXX = 0;
    sumYY = 0;
    for (const Tilt &vector : vectors) {
        sumXX += vector.x * vector.x;
        sumYY += vector.y * vector.y;
        if (squared(vector) > squared(largest)) {
            largest = vector;
        }
    }
}

std::optional<AccelStatistics> AccelWindow::statistics() const
{
    if (m_parts.size() < leastBlocks) {
        return std::nullopt;
    }
    Tilt largest;
    double sumXX = 0;
    double sumYY = 0;
    double count = 0;
    for (const Part &part : m_parts) {
        largest = squared(part.largest) > squared(largest) ? part.largest : largest;
        sumXX += part.sumXX;
        sumYY += part.sumYY;
        count += static_cast<double>(part.vectors.size());
    }
    AccelStatistics statistics;
    statistics.maximum = std::sqrt(squared(largest));
    statistics.maximumX = largest.x;
    statistics.maximumY = largest.y;
    statistics.direction = directionOf(largest);
    statistics.rms = std::sqrt((sumXX + sumYY) / count);
    statistics.rmsX = std::sqrt(sumXX / count);
    statistics.rmsY = std::sqrt(sumYY / count);
    return statistics;
}

} // namespace gorizont
