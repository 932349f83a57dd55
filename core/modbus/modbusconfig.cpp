#include "core/modbus/modbusconfig.h"

namespace gorizont {

ModbusConfig modbusConfig(const ServerConfig &config)
{
    ModbusConfig modbus;
    modbus.port = config.modbusPort;
    modbus.packing = config.modbusPacking;
    modbus.base = config.modbusBase;
    modbus.desk.clients = config.modbusClients;
    modbus.desk.idle = config.modbusIdle;
    modbus.desk.bind = config.modbusBind;
    modbus.desk.allow = config.modbusAllow;
    modbus.lines = config.lines;
    modbus.rules = {config.timing.readErrorLimit, config.timing.crcErrorLimit, config.hasLegacyStatusBits};
    return modbus;
}

} // namespace gorizont
