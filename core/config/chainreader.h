#pragma once

#include "core/values/displacement.h"
#include "core/values/lineconfig.h"

namespace gorizont {

class Findings;
class IniFile;

/// The sections [Chain{k}]: `Name`, then from the bottom `N{i}`, a tilt sensor of \a lines, and `L{i}`, the length of its
/// link in m; the first `N{i}` that is missing ends the chain. A sum over a wrong link would be wrong from there on, so a
/// chain with a mistake is left out as a whole.
QList<ChainConfig> readChains(const IniFile &file, const QList<LineConfig> &lines, Findings &findings);

} // namespace gorizont
