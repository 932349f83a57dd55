#pragma once

#include "core/station/correction.h"
#include "core/station/stationcomplaint.h"

#include <QByteArray>

#include <chrono>

namespace gorizont::station {

/// ACK.GAM (manual 004, section 5.2): a gamma sensor БДМГ on a digital input.
struct GammaConfig
{
    ParameterId parameter;
    std::chrono::seconds gate{1}; ///< pulses are counted for so long, 1…3600
    int inputBit = 0; ///< of the digital inputs, 0…31
    int blinkerBit = 0; ///< of the outputs, 0…31
    std::chrono::minutes checkAt{0}; ///< of the day: the daily self-check, 0…1439
    double sensitivity = 0; ///< Hz for one unit; 0: an ordinary parameter, through its polynomial
    double background = 0; ///< Hz
    bool isDirect() const { return sensitivity != 0; }
    bool operator==(const GammaConfig &) const = default;
};

/// Seven values: one a line with comments behind them, or all in one line. Empty: a value that is needed is faulty.
std::optional<GammaConfig> readGamma(const QString &file, const QByteArray &bytes, Complaints &complaints);

} // namespace gorizont::station
