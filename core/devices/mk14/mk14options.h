#pragma once

#include "core/devices/mk14/mk14parameters.h"
#include "core/values/sensorconfig.h"

#include <QStringList>

namespace gorizont::mk14 {

/// The options of a station as its driver, its service and its simulator understand them. Reads the file of `ParFile`.
struct Options
{
    QList<int> commands{8, 4}; ///< `Cmd`: data commands 1…8, one a turn, over and over
    quint32 outputs = 0; ///< `Outputs`: control word of the outputs, decimal or 0x…, repeated in every poll
    QList<ParameterName> parameters; ///< `ParFile`, else `Params`, else U, T, P, H, A, M; in the order of the answer
    bool isClockUtc = false; ///< `StationClock=UTC`; else the clock of the station shows local time
    QStringList complaints; ///< what was not understood, a sentence each

    static Options from(const SensorConfig &sensor);
};

/// A control word, decimal or hexadecimal with 0x. Empty: \a text is no number of at most 32 bits.
std::optional<quint32> outputWord(const QString &text);

} // namespace gorizont::mk14
