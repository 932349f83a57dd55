#include "core/devices/usmisn/usmisnvalues.h"

namespace gorizont::usmisn {

bool isPossible(const PortSettings &port)
{
    const bool isParityKnown = port.parity == Parity::None || port.parity == Parity::Even || port.parity == Parity::Odd;
    return port.baudRate >= slowestBaud && port.baudRate <= fastestBaud && isParityKnown;
}

bool isPossible(const Recording &recording)
{
    constexpr qint64 latest = 0xFFFFFFFF; // ten digits, and the clock of the device has 32 bits
    return recording.now > 0 && recording.start > recording.now && recording.start <= latest
        && recording.period >= shortestPeriod && recording.period <= longestPeriod
        && recording.delay >= std::chrono::seconds(0) && recording.delay <= longestDelay;
}

} // namespace gorizont::usmisn
