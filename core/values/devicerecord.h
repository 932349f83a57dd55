#pragma once

#include "core/values/timing.h"

#include <QByteArray>
#include <QMetaType>
#include <QString>

namespace gorizont {

/// A record that a device kept itself.
struct DeviceRecord
{
    int number = 0; ///< N
    UtcTime start; ///< by the clock of the device
    QString
        name; ///< what it is: the kind, or the name in the device; with N and the time it is there once; ≤ 64 characters
    QByteArray data;
    bool operator==(const DeviceRecord &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::DeviceRecord)
