#pragma once

#include "core/values/lineconfig.h"

namespace gorizont {

class Findings;
class IniFile;

/// The sections [Port1]…[Port{NumOfPorts}] with their sensors, each by itself: N is 0 where the file gives none, and
/// what two of them claim is settled by settleClaims().
QList<LineConfig> readLines(const IniFile &file, Findings &findings);

} // namespace gorizont
