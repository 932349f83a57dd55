#include "core/config/timingreader.h"

#include "core/config/sectionreader.h"

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

Timing readTiming(const IniFile &file, Findings &findings)
{
    constexpr SectionReader::Range any{0};
    constexpr SectionReader::Range positive{1};
    Timing timing;

    SectionReader timers(file, u"Timers"_s, findings);
    timers.take(u"TmUpdateInt"_s, timing.updateInterval, positive);
    timers.take(u"TmRun"_s, timing.run, positive);
    timers.take(u"TmStart"_s, timing.start, any);
    timers.take(u"TmSave"_s, timing.save, positive);

    SectionReader pauses(file, u"Pauses"_s, findings);
    pauses.take(u"PPauseTick"_s, timing.pauseTick, positive);
    pauses.take(u"PReOpen"_s, timing.reopenPause, any);
    pauses.take(u"PClose"_s, timing.closePause, any);
    pauses.take(u"PExit"_s, timing.exitLimit, any);

    SectionReader sleeps(file, u"Sleeps"_s, findings);
    sleeps.take(u"SAdrChange"_s, timing.addressChange, any);
    sleeps.take(u"SIdle"_s, timing.idle, any);
    sleeps.take(u"SRError"_s, timing.readErrorPause, any);
    sleeps.take(u"SCRCError"_s, timing.crcErrorPause, any);

    SectionReader timeOuts(file, u"TimeOuts"_s, findings);
    timeOuts.take(u"TORCom"_s, timing.readCommand, positive);
    timeOuts.take(u"TOWCom"_s, timing.writeCommand, positive);
    timeOuts.take(u"TORDat"_s, timing.readData, positive);
    timeOuts.take(u"TOWDat"_s, timing.writeData, positive);

    SectionReader errors(file, u"Errors"_s, findings);
    errors.take(u"NumRErrSrs"_s, timing.readErrorLimit, positive);
    errors.take(u"NumCErrSrs"_s, timing.crcErrorLimit, positive);
    return timing;
}

} // namespace gorizont
