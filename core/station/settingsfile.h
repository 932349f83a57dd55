#pragma once

#include "core/station/stationcomplaint.h"

#include <QByteArray>

#include <chrono>

namespace gorizont::station {

/// ACK.PSE (manual 004, section 3.3): what of it is in effect. Defaults are those of lines that are absent or faulty.
struct StationSettings
{
    int number = 1; ///< line 1: of this АКП and its address, 1…255
    bool hasDeviation = true; ///< line 2: σ is calculated
    int maximumHold = 0; ///< line 13: ticks of 1/18.2 s between a request and the new maximum
    std::chrono::seconds requestShift{0}; ///< line 21: of the requests to other АКП
    bool keepsSafeCopies = false; ///< line 22: primary data go to SAFE too
    int attempts = 3; ///< line 23: 1…
    int frequencyTicks = 18; ///< line 24: ticks of 1/18.2 s over which the pulses of a port are averaged, 1…
    std::chrono::seconds calibration{0}; ///< line 26
    std::chrono::seconds averaging{600}; ///< line 28: of parameters that give none, 1…86400
    double goodPercent = 50; ///< line 29: a mean needs more than this share of good values, 0…99.9
    bool isProtocolOff = false; ///< line 30: no protocol file
    std::chrono::seconds watchdog{0}; ///< line 31; 0: off
    bool isTest = false; ///< line 32: physical = measured, nothing is checked
    std::chrono::microseconds pulseFilter{0}; ///< line 33: shorter pulses are none

    bool operator==(const StationSettings &) const = default;
};

/// A tick of the clock of DOS is 1/18.2 s.
constexpr std::chrono::microseconds ticks(int count)
{
    return std::chrono::microseconds(static_cast<qint64>(count) * 10'000'000 / 182);
}

/// ACK.PSE: the first field of each line that holds anything is a value, in the order of the manual's list; the rest is comment.
/// Values that have no effect here (modem, radio, sound, screen) are named in one complaint about the whole file.
StationSettings readSettings(const QString &file, const QByteArray &bytes, Complaints &complaints);

} // namespace gorizont::station
