#pragma once

#include "core/devices/driver.h"

#include <memory>

namespace gorizont::mk14 {

/// The driver of one weather station: one data command a turn, by default 8 and 4 by turns, so that with one request a turn and two for
/// the whole set there are mean, instantaneous value, minimum, maximum, the deviations and the maximum of the wind, and
/// precipitation. The means are of this turn, what only the other commands bring is of their last one; a failed turn
/// forgets all of it.
std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::mk14
