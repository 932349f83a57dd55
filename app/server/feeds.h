#pragma once

#include "core/config/serverconfig.h"
#include "core/metrics/metricsserver.h"
#include "core/mqtt/mqttpublisher.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"

#include <QDeadlineTimer>
#include <QMap>
#include <QThread>
#include <QTimer>

namespace gorizont {

class Archive;
class HistoryWriter;

/// What carries readings to other programs over the network without being asked for a register: the MQTT publisher in a
/// thread of its own, the metrics in the servers thread. Each only if the ini asks for it. Main thread.
class Feeds : public QObject
{
    Q_OBJECT

public:
    struct Site
    {
        const ServerConfig &config;
        QString dataFolder;
        bool ownsDataFolder = true; ///< false: the queue there belongs to another copy of the program
        SensorRegistry &registry;
        Journal &journal;
        const HistoryWriter &history;
        const Archive &archive;
        QThread &servers;
    };

    explicit Feeds(const Site &site);

    /// How many are connected to one of the servers.
    void setClients(const QString &service, qsizetype count);

    void start();
    void stop();
    /// After stop(). False: the publisher's thread did not end in time.
    bool wait(const QDeadlineTimer &deadline) { return m_mqttThread.wait(deadline); }

Q_SIGNALS:
    /// At most once a second.
    void mqttStatusChanged(const gorizont::MqttStatus &status);

private:
    void makeMqtt(const Site &site);
    void makeMetrics(const Site &site);

    QThread m_mqttThread;
    std::unique_ptr<MqttPublisher> m_mqtt; ///< empty: no Host
    std::unique_ptr<MetricsServer> m_metrics; ///< empty: no Port
    QMap<QString, qsizetype> m_clients; ///< service → connected
    QTimer m_round; ///< asks those who do not tell by themselves
};

} // namespace gorizont
