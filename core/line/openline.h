#pragma once

#include "core/line/line.h"
#include "core/values/lineconfig.h"

#include <memory>

namespace gorizont {

/// Where COMn is found when the ini gives a port by its number.
struct PortNaming
{
    QString directory; ///< --ports DIR: `DIR/COMn`; empty: COMn on Windows, /dev/ttyS(n−1) elsewhere
};

/// The system's name of the port that \a config means. `Device=` wins over `Num=` (spec/gorizont.md, section 1).
QString deviceName(const LineConfig &config, const PortNaming &naming);

/// A closed serial or TCP line for \a config. Empty for `sim:`, which the simulation makes.
/// Call it in the thread that is going to use the line.
std::unique_ptr<Line> makeLine(const LineConfig &config, const PortNaming &naming, std::chrono::milliseconds pauseTick);

} // namespace gorizont
