#pragma once

#include "core/values/timing.h"

namespace gorizont {

class Findings;
class IniFile;

/// [Timers], [Pauses], [Sleeps], [TimeOuts] and [Errors] (manual 000, section 5). Waits of nothing are allowed, periods
/// and time-outs of nothing are not: they would turn a thread into a busy loop, or every exchange into a failure.
Timing readTiming(const IniFile &file, Findings &findings);

} // namespace gorizont
