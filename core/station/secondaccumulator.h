#pragma once

#include <QtGlobal>

#include <optional>
#include <span>
#include <vector>

namespace gorizont::station {

/// The mean of what each channel measured within a second (manual 004, section 5.1). A sample that is not finite does not count.
class SecondAccumulator
{
public:
    explicit SecondAccumulator(qsizetype channels);

    qsizetype channels() const { return static_cast<qsizetype>(m_sums.size()); }
    void add(qsizetype channel, double sample);
    /// One channel, many samples.
    void addBlock(qsizetype channel, std::span<const double> samples);
    /// One sample of every channel, many times: sample 0 of channel 0, 1, …, sample 1 of channel 0, …
    void addScans(std::span<const double> samples);

    /// The mean of every channel, empty where nothing came, and a new second begins.
    std::vector<std::optional<double>> take();

private:
    std::vector<double> m_sums;
    std::vector<quint32> m_counts;
};

} // namespace gorizont::station
