#pragma once

#include "core/station/sources/windpulses.h"

#include <QtGlobal>

#include <array>
#include <optional>

namespace gorizont::station {

constexpr std::size_t mostAnalogue =
    64; ///< two boards of 16 channels had the original; a source of today may have more
constexpr std::size_t mostDigital = 32; ///< bits of DIG
constexpr std::size_t mostWinds = 4;

/// What is measured at one moment, or the mean of a second, before any conversion. What is not measured is empty.
struct RawSample
{
    std::array<std::optional<double>, mostAnalogue> analogue; ///< V
    std::optional<double> frequency; ///< Hz, of the frequency input
    std::array<std::optional<bool>, mostDigital> digital;
    std::array<std::optional<double>, mostDigital> pulses; ///< a second, on a digital input
    std::array<WindRaw, mostWinds> winds;
    bool operator==(const RawSample &) const = default;
};

/// The mean of many samples. Of digital inputs and winds the last that there was: a mean of angles would be none.
class SampleMean
{
public:
    void add(const RawSample &sample);
    /// Empty: there was no sample since the last call.
    std::optional<RawSample> take();

private:
    struct Sum
    {
        double sum = 0;
        int count = 0;

        void add(const std::optional<double> &value);
        std::optional<double> mean() const;
    };

    std::array<Sum, mostAnalogue> m_analogue;
    std::array<Sum, mostDigital> m_pulses;
    Sum m_frequency;
    RawSample m_last; ///< its digital inputs and winds count
    int m_count = 0;
};

/// Takes from \a other what \a sample has not.
void fillFrom(RawSample &sample, const RawSample &other);

} // namespace gorizont::station
