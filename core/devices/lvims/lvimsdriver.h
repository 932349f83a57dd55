#pragma once

#include "core/devices/driver.h"
#include "core/devices/lvims/lvimslink.h"
#include "core/values/captureplan.h"

#include <memory>

namespace gorizont::lvims {

/// The options of a sensor as its driver and its service understand them.
struct Options
{
    Address address; ///< `unit` 0…255, `readfunction` 3 or 4
    std::optional<double> fullScale; ///< `percentcode`: the code of 100 %
    CapturePlan capture; ///< with complaints of its own
    QStringList complaints; ///< what was not understood, a sentence each

    static Options from(const SensorConfig &sensor);
};

/// The driver of one L-VIMS: the status block in each turn, and behind it what has changed since the turn before; nothing has
/// changed: one request. A module in its boot loader is asked for nothing but its mode.
std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::lvims
