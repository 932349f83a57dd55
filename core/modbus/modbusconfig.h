#pragma once

#include "core/config/serverconfig.h"
#include "core/net/service.h"
#include "core/values/statusword.h"

namespace gorizont {

/// All that the Modbus TCP server is told (spec/gorizont.md, sections 6 and 8).
struct ModbusConfig
{
    int port = 502; ///< IPPort1; 0: any free one
    ModbusPacking packing = ModbusPacking::ByType;
    int base = 0; ///< ModbusBase: register where the blocks of units 3 and 6 start, 0 or 1
    DeskConfig desk;
    QList<LineConfig> lines; ///< with their sensors
    StatusRules rules; ///< of the status words before the first poll

    bool operator==(const ModbusConfig &) const = default;
};

ModbusConfig modbusConfig(const ServerConfig &config);

} // namespace gorizont
