#include "core/station/sources/rawsample.h"

#include <utility>

namespace gorizont::station {

namespace {

template <typename T> void takeNewer(std::optional<T> &known, const std::optional<T> &newer)
{
    if (newer) {
        known = newer;
    }
}

template <typename T> void fill(std::optional<T> &known, const std::optional<T> &other)
{
    if (!known) {
        known = other;
    }
}

} // namespace

void SampleMean::Sum::add(const std::optional<double> &value)
{
    if (value) {
        sum += *value;
        ++count;
    }
}

std::optional<double> SampleMean::Sum::mean() const
{
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

void SampleMean::add(const RawSample &sample)
{
    ++m_count;
    for (std::size_t i = 0; i < mostAnalogue; ++i) {
        m_analogue[i].add(sample.analogue[i]);
    }
    m_frequency.add(sample.frequency);
    for (std::size_t i = 0; i < mostDigital; ++i) {
        takeNewer(m_last.digital[i], sample.digital[i]);
        m_pulses[i].add(sample.pulses[i]);
    }
    for (std::size_t i = 0; i < mostWinds; ++i) {
        takeNewer(m_last.winds[i].frequency, sample.winds[i].frequency);
        takeNewer(m_last.winds[i].phase, sample.winds[i].phase);
    }
}

std::optional<RawSample> SampleMean::take()
{
    if (m_count == 0) {
        return std::nullopt;
    }
    const SampleMean done = std::exchange(*this, SampleMean());
    RawSample mean = done.m_last;
    for (std::size_t i = 0; i < mostAnalogue; ++i) {
        mean.analogue[i] = done.m_analogue[i].mean();
    }
    for (std::size_t i = 0; i < mostDigital; ++i) {
        mean.pulses[i] = done.m_pulses[i].mean();
    }
    mean.frequency = done.m_frequency.mean();
    return mean;
}

void fillFrom(RawSample &sample, const RawSample &other)
{
    for (std::size_t i = 0; i < mostAnalogue; ++i) {
        fill(sample.analogue[i], other.analogue[i]);
    }
    fill(sample.frequency, other.frequency);
    for (std::size_t i = 0; i < mostDigital; ++i) {
        fill(sample.digital[i], other.digital[i]);
        fill(sample.pulses[i], other.pulses[i]);
    }
    for (std::size_t i = 0; i < mostWinds; ++i) {
        fill(sample.winds[i].frequency, other.winds[i].frequency);
        fill(sample.winds[i].phase, other.winds[i].phase);
    }
}

} // namespace gorizont::station
