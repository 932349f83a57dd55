#pragma once

#include <QHash>
#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>

#include <optional>

namespace gorizont::test {

/// As much of an MQTT 3.1.1 broker as one publisher needs, written from the standard; it can misbehave at will. It
/// lives in the thread of the test.
class ToyBroker : public QObject
{
    Q_OBJECT

public:
    struct Connect
    {
        QByteArray client;
        QByteArray willTopic;
        QByteArray will;
        bool isWillRetained = false;
        QByteArray user;
        QByteArray password;
    };

    struct Publish
    {
        QByteArray topic;
        QByteArray payload;
        int qos = 0;
        bool isRetained = false;
    };

    ToyBroker();

    /// Also again after stop(), on the same port.
    bool listen();
    /// Cuts off whoever is there.
    void stop();
    void disconnectAll();
    quint16 port() const { return m_port; }

    /// The payloads of \a topic in the order they came.
    QByteArrayList payloads(const QByteArray &topic) const;

    // What it does:
    int connackCode = 0;
    bool answersConnect = true;
    bool acknowledges = true;
    bool reads = true; ///< what is sent; for connections that come
    int endsAfter = -1; ///< cuts the connection instead of acknowledging that many publishes later

    // What it saw:
    QList<Connect> connects;
    QList<Publish> publishes;
    int unacknowledged = 0;

private:
    void takeConnection();
    void take(QTcpSocket *socket);
    bool takePacket(QTcpSocket *socket, QByteArray &buffer);
    void takeConnect(QTcpSocket *socket, const QByteArray &body);
    void takePublish(QTcpSocket *socket, int flags, const QByteArray &body);

    QTcpServer m_server;
    QHash<QTcpSocket *, QByteArray> m_buffers;
    quint16 m_port = 0;
};

} // namespace gorizont::test
