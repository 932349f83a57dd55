#pragma once

#include <chrono>

namespace gorizont {

using UtcTime = std::chrono::sys_time<std::chrono::microseconds>;
using SteadyTime = std::chrono::steady_clock::time_point;

inline UtcTime utcNow()
{
    return std::chrono::time_point_cast<std::chrono::microseconds>(std::chrono::system_clock::now());
}

/// The timers, pauses, sleeps, time-outs and error limits of the ini (manual 000, section 5), with the defaults of
/// absent keys (spec/gorizont.md, section 1).
struct Timing
{
    using ms = std::chrono::milliseconds;

    ms updateInterval{100}; ///< TmUpdateInt: period of the visible elements
    ms run{1000}; ///< TmRun: period of a polling cycle of a port
    ms start{1000}; ///< TmStart: time given to resources at the start
    ms save{1000}; ///< TmSave: period of the records in the text files
    ms pauseTick{100}; ///< PPauseTick: longest slice of any wait
    ms reopenPause{5000}; ///< PReOpen: pause after a failed attempt to open a port
    ms closePause{5000}; ///< PClose: pause between losing a port and opening it again
    ms exitLimit{1000}; ///< PExit: time given to an orderly end, then the process ends hard
    ms addressChange{16}; ///< SAdrChange: silence on the line before another address is asked
    ms idle{1}; ///< SIdle: pause after a polling cycle
    ms readErrorPause{0}; ///< SRError: pause after a read that failed
    ms crcErrorPause{600}; ///< SCRCError: pause after a wrong check sum
    ms readCommand{200}; ///< TORCom: an answer to a command
    ms writeCommand{100}; ///< TOWCom: writing a command
    ms readData{4000}; ///< TORDat: an answer that carries bulk data
    ms writeData{2000}; ///< TOWDat: writing bulk data
    int readErrorLimit = 10; ///< NumRErrSrs: failed reads in a row before the status word says so
    int crcErrorLimit = 10; ///< NumCErrSrs: wrong check sums in a row before the status word says so

    bool operator==(const Timing &) const = default;
};

} // namespace gorizont
