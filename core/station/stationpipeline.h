#pragma once

#include "core/station/stationconfig.h"
#include "core/values/timing.h"
#include "core/values/weather.h"

#include <memory>
#include <vector>

namespace gorizont::station {

/// What the sources measured in one second.
struct RawSecond
{
    SteadyTime time{}; ///< when it ended
    qint64 clock = 0; ///< the same by the clock of the station, seconds since 1970: of precipitation events
    /// By the index of the parameter: the mean of the second, before any conversion (V, Hz, or the state of a digital input; of a gamma
    /// sensor the frequency of its last gate). Empty, or not in the list: nothing was measured. A parameter on a digital input
    /// that has no value here gets 0 or 1 from `digital`.
    std::vector<std::optional<double>> raw;
    std::optional<quint32> digital; ///< the digital inputs; empty: not read, the last ones stay
};

/// What became of the value of a second.
enum class Verdict : quint8 {
    Good,
    Missing, ///< nothing was measured, or no finite number
    OutsideLimits, ///< not between left and right
    FarFromMean, ///< farther from the mean of the window than the error
    SupplyBad, ///< the supply voltage of the sensors was bad in this second
    Calm, ///< a direction while the speed was below left + error, or unknown
};

/// What the answer to command 8 has behind the means.
struct WindExtras
{
    std::optional<double> directionDeviation; ///< degrees, of the first A
    std::optional<double> speedDeviation; ///< m/s, of the first M
    std::optional<double> speedMaximum; ///< m/s, of the first M, since the last request
    bool operator==(const WindExtras &) const = default;
};

/// The work of a station once a second (manual 004, section 5; spec/mk14.md, "Processing"): raw means in, the state of every parameter
/// out. No clock, no threads, no I/O inside; the cost of a step does not depend on the length of any window.
class StationPipeline
{
public:
    explicit StationPipeline(const StationConfig &config);
    ~StationPipeline();

    /// To be called for every second, also for one in which nothing was measured.
    void step(const RawSecond &second);

    /// A request for data came: after the hold of ACK.PSE the maximum since the last request begins anew. A request within the
    /// hold changes nothing.
    void requested(SteadyTime time);

    /// Parameters as in ACK.PAR, then a wind W for each pair of A and M that ACK.PAR names no W for. Valid until the next step().
    const Weather &weather() const;
    /// How many of weather().parameters go into answers: those of ACK.PAR, the first ones.
    qsizetype sentParameters() const;
    WindExtras windExtras() const;

    Verdict verdict(int parameter) const; ///< of the last second, by the index of the parameter
    std::optional<double> physical(int parameter) const; ///< of the last second, whatever the verdict; empty: Missing

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gorizont::station
