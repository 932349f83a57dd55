#include "core/devices/and3/and3simulator.h"
namespace gorizont::and3 {
std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &, quint64)
{
    return nullptr;
}
} // namespace gorizont::and3
