#pragma once

#include <QMetaType>

namespace gorizont {

/// How the publisher fares, for the window and for the metrics.
struct MqttStatus
{
    bool isConnected = false;
    quint64 waiting = 0; ///< readings in the queue
    qint64 bytesOnDisk = 0; ///< of the queue's files
    quint64 published = 0; ///< readings that the broker has, since the start of the program
    quint64 lost = 0; ///< readings, since the start of the program

    bool operator==(const MqttStatus &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::MqttStatus)
