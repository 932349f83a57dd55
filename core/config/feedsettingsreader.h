#pragma once

#include "core/config/feedsettings.h"
#include "core/config/findings.h"
#include "core/config/inifile.h"

namespace gorizont {

MqttSettings readMqttSettings(const IniFile &file, Findings &findings);
MetricsSettings readMetricsSettings(const IniFile &file, Findings &findings);
OpcSettings readOpcSettings(const IniFile &file, Findings &findings);

} // namespace gorizont
