#include "core/devices/simulateddevice.h"

namespace gorizont {

SimulatedDevice::~SimulatedDevice() = default;

} // namespace gorizont
