#pragma once

#include "core/alarms/alarm.h"

namespace gorizont {

/// Messages for the dispatcher as sentences in the language of the program. Pure.
namespace alarmtext {

QString subject(const Alarm &alarm); ///< title and place: `АН-Д3 № 1 (COM10, address 1), 2nd floor`
QString meaning(const Alarm &alarm); ///< `No answer`
QString advice(const Alarm &alarm); ///< what to do, one or two sentences
QString sentence(const Alarm &alarm); ///< subject and meaning
QString sensorsNeedAttention(const Alarms &alarms); ///< `7 sensors need attention`

/// What a notification of the desktop says.
struct Notice
{
    QString title;
    QString text;
    bool operator==(const Notice &) const = default;
};

/// \a alarms: the oldest first, at least one. Of several the newest are named.
Notice notice(const Alarms &alarms);

} // namespace alarmtext

} // namespace gorizont
