#include "core/station/secondaccumulator.h"

#include <algorithm>
#include <cmath>

namespace gorizont::station {

SecondAccumulator::SecondAccumulator(qsizetype channels)
    : m_sums(static_cast<std::size_t>(channels))
    , m_counts(static_cast<std::size_t>(channels))
{
}

void SecondAccumulator::add(qsizetype channel, double sample)
{
    addBlock(channel, {&sample, 1});
}

void SecondAccumulator::addBlock(qsizetype channel, std::span<const double> samples)
{
    if (channel < 0 || channel >= channels()) {
        return;
    }
    double sum = 0;
    quint32 count = 0;
    for (const double sample : samples) {
        if (std::isfinite(sample)) {
            sum += sample;
            ++count;
        }
    }
    m_sums[static_cast<std::size_t>(channel)] += sum;
    m_counts[static_cast<std::size_t>(channel)] += count;
}

void SecondAccumulator::addScans(std::span<const double> samples)
{
    const std::size_t width = m_sums.size();
    for (std::size_t at = 0; width > 0 && at < samples.size(); at += width) {
        const std::size_t used = std::min(width, samples.size() - at);
        for (std::size_t channel = 0; channel < used; ++channel) {
            const double sample = samples[at + channel];
            const bool isUsable = std::isfinite(sample);
            m_sums[channel] += isUsable ? sample : 0;
            m_counts[channel] += isUsable ? 1 : 0;
        }
    }
}

std::vector<std::optional<double>> SecondAccumulator::take()
{
    std::vector<std::optional<double>> means(m_sums.size());
    for (std::size_t channel = 0; channel < m_sums.size(); ++channel) {
        if (m_counts[channel] > 0) {
            means[channel] = m_sums[channel] / m_counts[channel];
        }
    }
    std::fill(m_sums.begin(), m_sums.end(), 0);
    std::fill(m_counts.begin(), m_counts.end(), 0);
    return means;
}

} // namespace gorizont::station
