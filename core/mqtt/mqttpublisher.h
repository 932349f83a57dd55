#pragma once

#include "core/mqtt/brokersession.h"
#include "core/mqtt/mqttconfig.h"
#include "core/mqtt/mqttinbox.h"
#include "core/mqtt/mqttstatus.h"
#include "core/mqtt/publishingpace.h"
#include "core/values/journalentry.h"

#include <QMap>
#include <QObject>
#include <QSet>
#include <QTimer>

namespace gorizont {

/// Sends every reading to an MQTT broker, in order and at least once: a reading goes to the queue on the disk, from
/// there to the broker, and leaves the queue when the broker has confirmed it. After a crash some come twice, with the
/// same `seq`. States are retained messages and need no queue: the last one is sent at each connection.
/// Lives in a thread of its own, which disk and name server may hold up. updateReadings() and updateLine() may be called
/// from any thread and should be connected with Qt::DirectConnection: they only leave the value in an inbox of bounded
/// size.
class MqttPublisher : public QObject
{
    Q_OBJECT

public:
    explicit MqttPublisher(const MqttConfig &config, QObject *parent = nullptr);

public Q_SLOTS:
    void updateReadings(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);

    void start();
    /// Says good-bye to the broker; what waits stays on the disk.
    void stop();

Q_SIGNALS:
    void journal(const gorizont::JournalEntry &entry);
    /// At most once a second.
    void statusChanged(const gorizont::MqttStatus &status);

private:
    struct Known
    {
        SensorConfig sensor;
        LineConfig line;
    };

    /// A message on its way.
    struct Underway
    {
        int message = 0;
        quint64 sequence = 0;
        bool isThere = false;
    };

    void wake(bool isNeeded);
    void takeInbox();
    void takeReadings(const Readings &readings);
    void takeLine(const LineStatus &status);
    void setState(const QByteArray &topic, const QByteArray &payload);
    void pump();
    bool sendState();
    bool sendReading();
    void onConnected();
    void onPublished(const QList<int> &messages);
    void onEnded(BrokerTrouble trouble, const QString &detail);
    void lookAround();
    void tell(JournalKind kind, const QString &text);

    const MqttConfig m_config;
    MqttInbox m_inbox; ///< the only member that other threads touch
    QHash<int, Known> m_known; ///< by N
    QHash<int, LineConfig> m_lines; ///< by section
    PublishingPace m_pace;
    MessageQueue m_queue;
    BrokerSession m_session;

    QMap<QByteArray, QByteArray> m_states; ///< topic → what is retained there
    QHash<int, LineState> m_lineStates;
    QSet<QByteArray> m_unsentStates;
    QHash<int, QByteArray> m_statesUnderway; ///< message → topic
    std::deque<Underway> m_readingsUnderway;

    QTimer m_round; ///< once a second
    QTimer m_reconnect;
    QTimer m_calm;
    ReconnectPause m_pause;
    std::optional<BrokerTrouble> m_told; ///< since the last connection
    MqttStatus m_status; ///< as last emitted
    quint64 m_published = 0;
    quint64 m_dropped = 0; ///< from the inbox
    bool m_isRunning = false;
};

} // namespace gorizont
