#pragma once

#include "core/history/historyformat.h"

#include <QStringList>

namespace gorizont {

/// The paths of all months in \a folder, in ascending time; of Data and Acceleration.
QStringList monthFiles(const QString &folder, MonthFile kind);

/// The numbers of those of \a sensors that have a group in a record of \a kind, in the order of the groups.
QList<int> historyColumns(const QList<SensorConfig> &sensors, MonthFile kind);

} // namespace gorizont
