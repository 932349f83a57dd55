#pragma once

#include "core/station/service/door.h"

#include <QHash>
#include <QHostAddress>
#include <QObject>
#include <QTcpServer>
#include <QTimer>

class QTcpSocket;

namespace gorizont::station {

/// Dispatchers over TCP: the bytes of a serial line, every client with a connection of its own. Lives in the thread of the
/// station, never waits. At most mostClients at once: one more, and the one that was silent for longest is cut off. A client that
/// does not read its answers is cut off too. A port that is taken is tried again every few seconds.
class TcpDoor : public QObject
{
    Q_OBJECT

public:
    static constexpr qsizetype mostClients = 32;

    /// \a port 0: one that is free.
    TcpDoor(const QHostAddress &address, quint16 port, Answerer answerer, QObject *parent = nullptr);
    ~TcpDoor() override;

    void open();
    bool isOpen() const { return m_server.isListening(); }
    quint16 port() const { return m_server.serverPort(); } ///< 0 when closed
    qsizetype clients() const { return m_clients.size(); }

Q_SIGNALS:
    /// Whether dispatchers can be heard; \a text is a sentence for the journal.
    void stateChanged(bool isOpen, const QString &text);

private:
    struct Client
    {
        RequestListener listener;
        SteadyTime heard;
    };

    void onConnection();
    void onBytes(QTcpSocket *socket);
    void makeRoom();
    void pauseAccepting();

    QHostAddress m_address;
    quint16 m_wantedPort;
    Answerer m_answerer;
    QTcpServer m_server{this};
    QHash<QTcpSocket *, Client> m_clients;
    QTimer m_retry{this};
    bool m_isTold = false; ///< that the port cannot be had
};

} // namespace gorizont::station
