#pragma once

#include "core/devices/driver.h"

#include <memory>

namespace gorizont::ind3 {

std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::ind3
