#pragma once

#include "core/config/serverconfig.h"
#include "core/net/service.h"

#include <optional>

namespace gorizont {

/// All that the ADC24 TCP server is told (spec/gorizont.md, section 7). Who may connect, how many at a time and how long
/// they may be silent is said once for both servers: by ModbusBind, ModbusAllow, ModbusClients and ModbusIdle.
struct Adc24Config
{
    int port = 503; ///< IPPort2; 0: any free one
    int number = 0; ///< N of the accelerometer
    Adc24Axis axis = Adc24Axis::X;
    int ringPackets = 8192; ///< SrsBufSize, packets of 32 samples
    quint16 initialWord = 0x0F00; ///< status word of the sensor before the first poll
    DeskConfig desk;
    std::chrono::milliseconds patience{5000}; ///< a part of a request that is not continued for so long is dropped

    bool operator==(const Adc24Config &) const = default;
};

/// Empty: CanADC24=0, or the site has no accelerometer.
std::optional<Adc24Config> adc24Config(const ServerConfig &config);

} // namespace gorizont
