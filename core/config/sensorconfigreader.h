#pragma once

#include "core/values/sensorconfig.h"

#include <QList>

namespace gorizont {

class Findings;
class IniFile;
class SectionReader;

/// The sensors of the port that \a section describes: every index up to NumOfSensors that has `adr{i}` or `Name{i}`.
QList<SensorConfig> readSensors(const IniFile &file, SectionReader &section, int port, Findings &findings);

} // namespace gorizont
