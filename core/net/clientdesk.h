#pragma once

#include "core/net/allowlist.h"
#include "core/net/clientdiary.h"
#include "core/net/clientpeer.h"
#include "core/net/desksentences.h"
#include "core/net/tcplistener.h"
#include "core/values/journalentry.h"

#include <vector>

namespace gorizont {

/// Where the clients of one service come and go: lets in, makes room, sends away, counts, and tells the journal.
/// Servers thread. A port that cannot be had is tried for until close().
class ClientDesk : public QObject
{
    Q_OBJECT

public:
    ClientDesk(const Service &service, const DeskConfig &config, QObject *parent = nullptr);
    ~ClientDesk() override;

    const QString &service() const { return m_service.name; }

    /// False: \a bind, empty for all addresses, is not one; the journal has been told problem().
    bool open(const QString &bind, quint16 port);
    /// Ends every connection.
    void close();

    bool isListening() const { return m_listener.isListening(); }
    quint16 port() const { return m_listener.port(); } ///< 0: not listening
    /// Why the port is not served, one sentence; empty: nothing is wrong.
    const QString &problem() const { return m_problem; }
    /// Who is connected now, in the order they came.
    QList<gorizont::ClientInfo> clients() const;

    void tell(JournalKind kind, const QString &text);

public Q_SLOTS:
    /// Cuts off one connection; nothing happens when it has gone meanwhile. From another thread by a queued call.
    void dismiss(const QHostAddress &address, quint16 port);

Q_SIGNALS:
    void listening();
    /// Once per change of problem().
    void listenFailed();
    void journal(const gorizont::JournalEntry &entry);
    /// Once a second while somebody listens to this signal and somebody is connected, and once after the last one left.
    void clientsChanged(const QList<gorizont::ClientInfo> &clients);

private:
    void onListening();
    void onListenFailed(QAbstractSocket::SocketError error, const QString &reason);
    void onConnected(const Arrival &arrival);
    void admit(const Arrival &arrival);
    void onEnded(ClientPeer *peer, ClientPeer::End how);
    void remove(ClientPeer *peer);
    void sendAway(ClientPeer *peer, ClientTrouble reason);
    void makeRoom();
    void lookAround();
    void sendIdleAway(SteadyTime now);
    void publishClients();
    void tellTrouble(ClientTrouble trouble, const QHostAddress &address);

    const Service m_service;
    const DeskConfig m_config;
    const AllowList m_allowed;
    const DeskSentences m_sentences;
    ClientDiary m_diary;
    TcpListener m_listener;
    PeerWatch m_watch;
    quint16 m_wantedPort = 0;
    QString m_problem;
    QTimer m_round; ///< once a second while open
    std::vector<ClientPeer *> m_peers; ///< children, in the order they came
    bool m_hasPublished = false; ///< the last clientsChanged() was not empty
};

} // namespace gorizont
