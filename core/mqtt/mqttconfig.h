#pragma once

#include "core/config/serverconfig.h"
#include "core/mqtt/messagequeue.h"
#include "core/values/statusword.h"

namespace gorizont {

/// All that the publisher is told.
struct MqttConfig
{
    MqttSettings settings; ///< with prefix and client id
    QString folder; ///< of the queue; created when needed
    QList<LineConfig> lines; ///< with their sensors
    StatusRules rules; ///< of the status words before the first poll
    MessageQueue::Limits queue;

    qsizetype mostReadings = 20000; ///< that wait in memory for the publisher
    int window = 100; ///< messages on their way to the broker
    std::chrono::seconds keepAlive{30}; ///< a broker that is silent for one and a half times as long is lost
    std::chrono::milliseconds connectLimit{15000}; ///< for reaching the broker and being let in
    std::chrono::milliseconds calm{10000}; ///< a connection that lasts as long makes the next pause short again
};

/// \a dataFolder: where the queue goes; it also makes the client id, so that two copies of the program differ.
MqttConfig mqttConfig(const ServerConfig &config, const QString &dataFolder);

} // namespace gorizont
