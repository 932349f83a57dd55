#include "core/modbus/modbusconfig.h"

namespace gorizont {

ModbusConfig modbusConfig(const ServerConfig &config)
{
    ModbusConfig modbus;
    modbus.port = config.modbusPort;
    modbus.packing = config.modbusPacking;
    modbus.base = config.modbusBase;
    modbus.clients = config.modbusClients;
    modbus.idle = config.modbusIdle;
    modbus.bind = config.modbusBind;
    modbus.allow = config.modbusAllow;
    modbus.lines = config.lines;
    modbus.rules = {config.timing.readErrorLimit, config.timing.crcErrorLimit, config.hasLegacyStatusBits};
    return modbus;
}

} // namespace gorizont
