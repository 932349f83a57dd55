#pragma once

#include "core/config/archivesettings.h"

namespace gorizont {

class Findings;
class IniFile;

ArchiveSettings readArchiveSettings(const IniFile &file, Findings &findings);

} // namespace gorizont
