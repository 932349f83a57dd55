#pragma once

#include "core/values/lineconfig.h"

namespace gorizont {

class Findings;
class IniFile;

/// Settles what two claim and one can have: a port of the computer, a site number, an address on a line. The first that
/// is polled keeps it, the second is switched off. What is off anyway takes nothing from anybody; but every sensor gets
/// a site number of its own, because its column in the files and its place in the registry hang on it.
void settleClaims(QList<LineConfig> &lines, const IniFile &file, Findings &findings);

} // namespace gorizont
