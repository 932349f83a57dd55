#pragma once

#include "core/values/reading.h"

#include <QByteArray>
#include <QList>
#include <QMetaType>
#include <QString>

namespace gorizont {

/// A record that a device kept itself.
struct DeviceRecord
{
    int number = 0; ///< N
    UtcTime start; ///< by the clock of the device
    /// What it is: the kind, or the name in the device. With N and the time it is there once. At most 64 characters.
    QString name;
    QByteArray data;
    bool operator==(const DeviceRecord &) const = default;
};

/// What one device kept while nobody asked it.
struct DeviceRecords
{
    int number = 0; ///< N, of all of them
    QString source; ///< what the gaps say that they were filled from, at most 64 characters; empty: none is filled
    QList<DeviceRecord> records;
    Readings readings; ///< what the records say, corrected like every reading
    bool operator==(const DeviceRecords &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::DeviceRecord)
Q_DECLARE_METATYPE(gorizont::DeviceRecords)
