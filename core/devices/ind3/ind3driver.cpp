#include "core/devices/ind3/ind3driver.h"
namespace gorizont::ind3 {
std::unique_ptr<Driver> makeDriver(DriverSettings)
{
    return nullptr;
}
} // namespace gorizont::ind3
