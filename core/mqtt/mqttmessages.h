#pragma once

#include "core/values/lineconfig.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"

#include <QByteArray>

/// What is sent to the broker, as JSON in one line, UTF-8. Pure.
namespace gorizont::mqttmessage {

/// A reading as `--print-readings` prints it (core/values/readingjson.h) and `seq`, its number in the queue: it rises by
/// one from reading to reading, also over restarts. A receiver drops what is not above the last it has seen of this
/// prefix: the same reading again. Numbers that are left out were lost.
QByteArray reading(const QByteArray &json, quint64 sequence);

/// `time`, `number`, `name`, `place`, `type`, `port`, `address`, `status` (the word), `code` (its critical code, 0…11).
QByteArray sensorState(const Reading &reading, const SensorConfig &sensor, const LineConfig &line);

/// `time`, `port`, `index` (of the section), `name`, `state` (`off`, `opening`, `open`, `openFailed`, `lost`, `service`)
/// and, while it cannot be used, `error`: what the system says.
QByteArray portState(UtcTime time, const LineStatus &status, const LineConfig &line);

} // namespace gorizont::mqttmessage
