#pragma once

#include "core/station/sources/sourcefile.h"
#include "core/station/stationconfig.h"
#include "core/values/lineconfig.h"

namespace gorizont::station {

/// Another АКП that this station polls and gathers: a `q` line of ACK.INI with the number of that АКП. Its field `extra` says
/// `[COMMAND:][ID,ID,…]`: the data command (4), and which parameters of ACK.PAR the values of its answer are, in their order; a
/// dash leaves one out. Without a list they are not in ACK.PAR: the dispatcher asks for them under the number of that АКП.
struct GatheredObject
{
    int number = 1; ///< its address, 1…255
    std::chrono::seconds period{0}; ///< between two requests
    LineConfig line;
    int command = 4; ///< 1…8
    QList<std::optional<ParameterId>> ids;
    bool operator==(const GatheredObject &) const = default;

    static constexpr std::chrono::seconds usualPeriod{60}; ///< where ACK.INI keeps no records of it
};

/// A `q` line with the station's own number.
struct DispatcherLine
{
    LineConfig line;
    bool isListening = false; ///< `q:tcp://ADDRESS:PORT`: the station waits there for dispatchers
    bool operator==(const DispatcherLine &) const = default;
};

/// Records of one object in the database.
struct RecordedObject
{
    int number = 1;
    std::chrono::seconds period{0}; ///< > 0
    QList<int> parameters; ///< indices of ACK.PAR; of a gathered АКП: none, all that it sends are recorded
    bool isGathered = false;
    bool operator==(const RecordedObject &) const = default;
};

/// All that the files of a station say, ready to be started.
struct StationPlan
{
    StationConfig config;
    SourcePlan sources;
    QList<DispatcherLine> dispatchers;
    QList<GatheredObject> gathered;
    QList<RecordedObject> records;
    QList<StationComplaint> complaints;
};

/// The name of the file of sources.
inline const QString sourceFileName = QStringLiteral("ACK.SRC");

/// Reads the folder. Never fails: what is not usable is left out and complained about.
StationPlan readPlan(const QString &folder);

/// Pure: the plan of \a config and \a sources.
StationPlan planOf(const StationConfig &config, const SourcePlan &sources, const QString &folder);

} // namespace gorizont::station
