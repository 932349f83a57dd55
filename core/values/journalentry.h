#pragma once

#include "core/values/timing.h"

#include <QMetaType>
#include <QString>

namespace gorizont {

/// The kinds of events, with the digits that stand for them in the log file (spec/gorizont.md, section 3).
enum class JournalKind : quint8 { Info = 0, On = 1, Off = 2, Error = 3 };

/// One event of the user's journal.
struct JournalEntry
{
    JournalKind kind = JournalKind::Info;
    UtcTime time;
    QString text; ///< one sentence in the language of the program
    int port = 0; ///< LineConfig::index; 0: not about a port
    int number = 0; ///< N; 0: not about a sensor

    bool operator==(const JournalEntry &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::JournalEntry)
