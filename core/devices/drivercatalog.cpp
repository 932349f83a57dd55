#include "core/devices/drivercatalog.h"

#include "core/devices/and3/and3driver.h"
#include "core/devices/and3/and3simulator.h"
#include "core/devices/ind3/ind3driver.h"
#include "core/devices/ind3/ind3simulator.h"
#include "core/devices/lvims/lvimsdriver.h"
#include "core/devices/lvims/lvimssimulator.h"
#include "core/devices/mk14/mk14driver.h"
#include "core/devices/mk14/mk14simulator.h"
#include "core/devices/usmisn/usmisndriver.h"
#include "core/devices/usmisn/usmisnsimulator.h"

#include <array>

namespace gorizont {

namespace {

/// One line a device. Static registration objects would be lost in a static library (spec/traps.md, 7).
struct Entry
{
    SensorType type;
    std::unique_ptr<Driver> (*makeDriver)(DriverSettings);
    std::unique_ptr<SimulatedDevice> (*makeSimulator)(const SensorConfig &, quint64 seed);
};

constexpr std::array<Entry, 5> catalog{{
    {SensorType::InD, ind3::makeDriver, ind3::makeSimulator},
    {SensorType::AnD3, and3::makeDriver, and3::makeSimulator},
    {SensorType::UsmIsn, usmisn::makeDriver, usmisn::makeSimulator},
    {SensorType::LVims, lvims::makeDriver, lvims::makeSimulator},
    {SensorType::Mk14, mk14::makeDriver, mk14::makeSimulator},
}};

const Entry *find(SensorType type)
{
    for (const Entry &entry : catalog) {
        if (entry.type == type) {
            return &entry;
        }
    }
    return nullptr;
}

} // namespace

std::unique_ptr<Driver> makeDriver(DriverSettings settings)
{
    const Entry *entry = find(settings.sensor.type);
    return entry ? entry->makeDriver(std::move(settings)) : nullptr;
}

std::unique_ptr<SimulatedDevice> makeSimulatedDevice(const SensorConfig &sensor, quint64 seed)
{
    const Entry *entry = find(sensor.type);
    return entry ? entry->makeSimulator(sensor, seed) : nullptr;
}

} // namespace gorizont
