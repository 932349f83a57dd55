#include "core/station/parameterjudge.h"

#include "core/station/wind.h"
#include "core/values/weather.h"

#include <cmath>

namespace gorizont::station {

ParameterJudge::ParameterJudge(const ParameterConfig &config, const Corrections &corrections)
    : m_config(config)
    , m_corrections(corrections)
    , m_isGated(config.error && !config.isA(weathercode::windSpeed) && !config.conversion.isThreshold())
{
}

void ParameterJudge::measureGamma(const GammaConfig &gamma)
{
    m_gamma = gamma;
    m_isGated = false;
}

Judged ParameterJudge::judge(
    std::optional<double> raw, const Temperatures &temperatures, std::optional<double> windowMean) const
{
    if (!raw || !std::isfinite(*raw)) {
        return {};
    }
    if (m_isTest) {
        return {raw, Verdict::Good};
    }
    const double value = physical(*raw, temperatures);
    if (!std::isfinite(value)) {
        return {};
    }
    if (!m_config.limits.contains(value)) {
        return {value, Verdict::OutsideLimits};
    }
    if (m_isGated && windowMean && isFar(value, *windowMean)) {
        return {value, Verdict::FarFromMean};
    }
    return {value, Verdict::Good};
}

double ParameterJudge::physical(double raw, const Temperatures &temperatures) const
{
    if (m_gamma) {
        return (raw - m_gamma->background) / m_gamma->sensitivity;
    }
    const double measured = raw + inputCorrection(m_corrections, temperatures.input);
    return converted(m_config.conversion, m_config.limits, m_config.error.value_or(0), measured)
        + physicalCorrection(m_corrections, temperatures.usual, raw);
}

bool ParameterJudge::isFar(double value, double mean) const
{
    const double distance =
        m_config.isA(weathercode::windDirection) ? angleBetween(value, mean) : std::abs(value - mean);
    return distance > *m_config.error;
}

} // namespace gorizont::station
