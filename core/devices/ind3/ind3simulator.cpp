#include "core/devices/ind3/ind3simulator.h"
namespace gorizont::ind3 {
std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &, quint64)
{
    return nullptr;
}
} // namespace gorizont::ind3
