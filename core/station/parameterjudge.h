#pragma once

#include "core/station/correction.h"
#include "core/station/gammafile.h"
#include "core/station/parameterfile.h"

namespace gorizont::station {

/// What became of the value of a second.
enum class Verdict : quint8 {
    Good,
    Missing, ///< nothing was measured, or no finite number
    OutsideLimits, ///< not between left and right
    FarFromMean, ///< farther from the mean of the window than the error
    SupplyBad, ///< the supply voltage of the sensors was bad in this second
    Calm, ///< a direction while the speed was below left + error, or unknown
};

/// A measured value as a physical one, and whether it counts.
struct Judged
{
    std::optional<double> physical; ///< empty: Missing
    Verdict verdict = Verdict::Missing;

    bool isGood() const { return verdict == Verdict::Good; }
    /// The physical value when it counts.
    std::optional<double> good() const { return isGood() ? physical : std::nullopt; }
    bool operator==(const Judged &) const = default;
};

/// The temperatures by which a value is corrected; empty: none was ever measured.
struct Temperatures
{
    std::optional<double> input; ///< of the thermometer that INPUT names
    std::optional<double> usual; ///< of the usual thermometer
};

/// The way of one value of one parameter: + INPUT → polynomial → + CORRECT + METEO + REAL → limits → error gate (spec/mk14.md,
/// "Processing"). Keeps no state.
class ParameterJudge
{
public:
    ParameterJudge(const ParameterConfig &config, const Corrections &corrections);

    /// A gamma sensor with a sensitivity: (frequency − background) ÷ sensitivity instead of polynomial and corrections.
    void measureGamma(const GammaConfig &gamma);
    void beginTest() { m_isTest = true; } ///< physical = measured, nothing is checked

    /// \a windowMean: what the error gate compares with; empty: there is no good value yet, and any passes.
    Judged judge(std::optional<double> raw, const Temperatures &temperatures, std::optional<double> windowMean) const;

private:
    double physical(double raw, const Temperatures &temperatures) const;
    bool isFar(double value, double mean) const;

    ParameterConfig m_config;
    Corrections m_corrections;
    std::optional<GammaConfig> m_gamma;
    bool m_isTest = false;
    bool m_isGated = false;
};

} // namespace gorizont::station
