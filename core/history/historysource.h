#pragma once

#include "core/values/sensorconfig.h"
#include "core/values/series.h"

#include <QString>
#include <QTimeZone>

namespace gorizont {

/// A folder of old text and binary files, and the site whose sensors they hold: the columns of a record are those of its
/// sensors in ascending N.
struct HistoryFolder
{
    QString path; ///< of `2018_02_data.txt`, `2018_02_adata.txt` and `Bin/`
    QList<SensorConfig> sensors;
    QTimeZone zone = QTimeZone::systemTimeZone(); ///< of the clock that stands in the files
    double gravity = 9.81347; ///< m/s²
};

/// What a look at the folder tells.
struct HistoryOverview
{
    std::optional<TimeSpan> span; ///< of all records; empty: there are none
    qsizetype foreign = 0; ///< files whose records hold another number of sensors than the site: they are not read
};

/// Reads the beginning and the end of every file. May take as long as the disk does.
HistoryOverview overviewOf(const HistoryFolder &folder);

/// Answers from the files, each question on a thread of the global pool; a cancelled question stops reading. Records of
/// another number of sensors are left out; samples are in the axes of the device.
SeriesSource historySource(const HistoryFolder &folder);

} // namespace gorizont
