#pragma once

#include "core/values/series.h"

#include <QByteArray>
#include <QList>
#include <QString>

namespace gorizont {

/// A record that a device kept itself.
struct DeviceRecord
{
    int number = 0; ///< N
    UtcTime start; ///< by the clock of the device
    QString name; ///< what it is: the kind, or the name in the device
    QByteArray data;
    bool operator==(const DeviceRecord &) const = default;
};

/// What was downloaded from one device.
struct DeviceRecords
{
    int number = 0; ///< N, of all of them
    QString source; ///< where they come from, for the gaps that they fill
    QList<DeviceRecord> records;
    QList<TimeSpan> filled; ///< times that they stand for
    bool operator==(const DeviceRecords &) const = default;
};

} // namespace gorizont
