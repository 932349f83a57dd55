#pragma once

#include "core/modbus/unitimages.h"

namespace gorizont {

/// A request to \a unit and its answer byte by byte, as Markdown: what the server of this very configuration sends when
/// the first fitting sensor has just given an example reading. Empty: the unit has no such sensor.
QString registerExample(const ModbusConfig &config, const UnitImage &unit);

/// `AB`, `DCBA`, …: the order of the bytes on the wire; A is the most significant one.
QString byteOrder(RegisterType type, RegisterOrder order);

} // namespace gorizont
