#pragma once

#include "core/config/feedsettings.h"

#include <QHostAddress>
#include <QObject>
#include <QSocketNotifier>
#include <QTimer>

#include <memory>
#include <optional>

struct mosquitto;

namespace gorizont {

/// Why there is no connection to the broker.
enum class BrokerTrouble : quint8 {
    UnknownHost,
    Unreachable, ///< nobody listens there, or it is not a broker
    NoAnswer, ///< not in time
    UnreadableFile, ///< certificate, key or password; the detail names it
    TlsFailed,
    NotTrusted, ///< the certificate of the broker
    WrongPassword,
    NotAuthorized,
    Rejected, ///< for another reason
    Lost, ///< it was there
};

/// One connection at a time to an MQTT broker, over libmosquitto without threads of its own: sockets and timers of the
/// thread it lives in serve it. Nothing waits but the library's look at the name server, which has just answered the
/// same question asked without waiting.
class BrokerSession : public QObject
{
    Q_OBJECT

public:
    struct Access
    {
        MqttSettings settings;
        QByteArray willTopic; ///< gets `offline`, retained, when the connection breaks
        int window = 100; ///< messages on their way
        std::chrono::seconds keepAlive{30};
        std::chrono::milliseconds limit{15000}; ///< for open()
    };

    explicit BrokerSession(const Access &access, QObject *parent = nullptr);
    ~BrokerSession() override;

    /// connected() or ended() follows. Files are read anew at each attempt.
    void open();
    /// Sends \a lastWords, retained, to the will's topic first; nothing is emitted.
    void close(const QByteArray &lastWords);

    bool isConnected() const { return m_isConnected; }
    /// The number that published() will name; empty: the connection is about to end.
    std::optional<int> publish(const QByteArray &topic, const QByteArray &payload, bool isRetained);

Q_SIGNALS:
    void connected();
    /// The broker has them (QoS 0: they left).
    void published(const QList<int> &messages);
    /// Once after each open(); \a detail is what library or system say, possibly nothing.
    void ended(gorizont::BrokerTrouble trouble, const QString &detail);

private:
    struct Destroy
    {
        void operator()(mosquitto *client) const;
    };

    void onFound(const QList<QHostAddress> &addresses);
    bool prepare();
    bool prepareUser();
    bool prepareTls();
    QByteArray ownFamily(const QList<QHostAddress> &addresses) const;
    void watch();
    void stopWatching();
    void settle(int outcome);
    void settleLater(int outcome);
    void end(BrokerTrouble trouble, const QString &detail);
    void drop();
    BrokerTrouble troubleOf(int outcome) const;
    QString detailOf(int outcome) const;

    const Access m_access;
    std::unique_ptr<mosquitto, Destroy> m_client; ///< empty: not open
    std::unique_ptr<QSocketNotifier> m_reads;
    std::unique_ptr<QSocketNotifier> m_writes;
    QTimer m_round; ///< the library's own chores
    QTimer m_limit;
    int m_lookup = -1; ///< of the name, while it runs
    unsigned m_attempts = 0; ///< since the last connection
    bool m_isConnected = false;

    // What the library reports in the middle of its work, until settle().
    std::optional<int> m_answer; ///< of the broker to CONNECT
    QList<int> m_delivered;
    QString m_complaint; ///< the last error it logged
};

} // namespace gorizont
