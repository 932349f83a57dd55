#include "core/station/correction.h"

#include "core/station/polynomial.h"

#include <algorithm>

namespace gorizont::station {

double CorrectionTable::at(double key, double x) const
{
    const auto row = std::upper_bound(rows.cbegin(), rows.cend(), key, [](double wanted, const Row &candidate) {
        return wanted < candidate.below;
    });
    return row == rows.cend() ? 0 : polynomial(row->coefficients, x);
}

double RealCorrection::at(double temperature, double x) const
{
    if (byTemperature.isEmpty()) {
        return table.at(temperature, x);
    }
    double sum = 0;
    for (qsizetype i = byTemperature.size(); i-- > 0;) {
        sum = sum * x + polynomial(byTemperature[i], temperature);
    }
    return sum;
}

double inputCorrection(const Corrections &corrections, std::optional<double> temperature)
{
    return temperature ? corrections.input.at(*temperature, *temperature) : 0;
}

double physicalCorrection(const Corrections &corrections, std::optional<double> temperature, double raw)
{
    const double byValue = corrections.correct.at(raw, raw);
    if (!temperature) {
        return byValue;
    }
    return byValue + corrections.meteo.at(*temperature, *temperature) + corrections.real.at(*temperature, raw);
}

} // namespace gorizont::station
