#pragma once

#include "core/devices/driver.h"

#include <memory>

namespace gorizont::and3 {

std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::and3
