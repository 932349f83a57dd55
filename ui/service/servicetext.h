#pragma once

#include "core/values/lineconfig.h"
#include "core/values/result.h"

#include <optional>

namespace gorizont {

/// Sentences that the service windows of all devices have in common. Pure.
namespace servicetext {

QString fault(Fault fault); ///< `no answer`: why something could not be read or written

QString deviceName(SensorType type); ///< `ИН-Д3`, `АН-Д3`: as the manual names the windows
QString menuTitle(
    SensorType type, const QString &port); ///< `Настройка датчиков ИН-Д3 на COM16`; without a port its part is left out

/// Which key of the ini has to follow a sensor that moved from address \a from to \a to, or that there is none.
QString iniReminder(const LineConfig &line, SensorType type, int from, int to);

/// Whether devices of \a type are found by addresses on the line; those of the others are their places {i} in the ini.
bool hasAddresses(SensorType type);

/// N of the sensor of \a type that the ini has at \a address, whether it is on or off; 0: none.
int numberAt(const LineConfig &line, SensorType type, int address);

/// `12`, or `12 (N 4 in the ini)`: a free address that is meant for somebody already.
QString addressTitle(const LineConfig &line, int address);

/// What a user types: point and comma are both decimal marks, whatever the language. Empty: not a number.
std::optional<double> number(const QString &text);

} // namespace servicetext

} // namespace gorizont
