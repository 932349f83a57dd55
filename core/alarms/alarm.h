#pragma once

#include "core/values/linestatus.h"
#include "core/values/statusword.h"

#include <QList>
#include <QMetaType>
#include <QString>

namespace gorizont {

/// One message for the dispatcher (manual 000, section 11.2; spec/gorizont.md, section 8): a critical code of a sensor, or
/// a port that fails with all its sensors.
struct Alarm
{
    quint64 id = 0; ///< 1…, grows from message to message
    int port = 0; ///< LineConfig::index
    int number = 0; ///< N; 0: the whole port
    int sensors = 1; ///< how many sensors it is about
    StatusCode code = StatusCode::Good; ///< never Good in a message
    LineState line = LineState::Open; ///< of a whole port: how it fails
    QString title; ///< `АН-Д3 № 1 (COM10, address 1)` or `COM10`
    QString place; ///< Place{i} of the sensor, Name of the port; may be empty
    SensorType type = SensorType::None; ///< of the sensor
    QString cause; ///< what the device itself says of it, in one sentence; empty: no more than the code
    UtcTime began;
    bool isAcknowledged = false;

    bool isWholePort() const { return number == 0; }
    bool operator==(const Alarm &) const = default;
};

using Alarms = QList<Alarm>;

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::Alarm)
