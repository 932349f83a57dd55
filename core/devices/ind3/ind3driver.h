#pragma once

#include "core/devices/driver.h"

#include <memory>

namespace gorizont::ind3 {

/// The driver of one ИН-Д2/3/7/9. The option `protocol` of the sensor names what it speaks: `2.11` (default), `2.10` or
/// `modbus`.
std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::ind3
