#pragma once

#include "core/config/serverconfig.h"
#include "core/values/statusword.h"

namespace gorizont {

/// All that the Modbus TCP server is told (spec/gorizont.md, sections 6 and 8).
struct ModbusConfig
{
    int port = 502; ///< IPPort1; 0: any free one
    ModbusPacking packing = ModbusPacking::ByType;
    int base = 0; ///< ModbusBase: register where the blocks of units 3 and 6 start, 0 or 1
    int clients = 64; ///< ModbusClients: connections at a time, 1…
    std::chrono::milliseconds idle{std::chrono::minutes(10)}; ///< ModbusIdle: without a request; 0: never cut off
    QString bind; ///< ModbusBind: address to listen on; empty: all, IPv4 and IPv6
    QStringList allow; ///< ModbusAllow: addresses and CIDR blocks; empty: everybody
    QList<LineConfig> lines; ///< with their sensors
    StatusRules rules; ///< of the status words before the first poll

    std::chrono::milliseconds retry{5000}; ///< between two attempts to take the port
    std::chrono::milliseconds stall{5000}; ///< a client with a full backlog that takes nothing for so long is dropped
    std::chrono::milliseconds acceptPause{1000}; ///< after a connection could not be accepted

    bool operator==(const ModbusConfig &) const = default;
};

ModbusConfig modbusConfig(const ServerConfig &config);

} // namespace gorizont
