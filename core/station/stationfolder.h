#pragma once

#include "core/station/stationconfig.h"

namespace gorizont::station {

/// The files of a station in \a folder, in any case and with Latin or Cyrillic letters. What could not be read, stands twice under
/// names that mean the same, or is longer than 1 MiB is complained about. Keeps no state: for any thread.
StationFiles readStationFolder(const QString &folder, QList<StationComplaint> &complaints);

/// Both steps in one: files and what they say.
StationReading readStationIn(const QString &folder);

} // namespace gorizont::station
