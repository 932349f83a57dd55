#include "core/devices/and3/and3driver.h"
namespace gorizont::and3 {
std::unique_ptr<Driver> makeDriver(DriverSettings)
{
    return nullptr;
}
} // namespace gorizont::and3
