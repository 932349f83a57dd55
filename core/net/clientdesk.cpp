#include "core/net/clientdesk.h"

#include <QLoggingCategory>
#include <QMetaMethod>

#include <algorithm>
#include <unistd.h>

namespace gorizont {

namespace {

Q_LOGGING_CATEGORY(logServer, "gorizont.server", QtInfoMsg)

using namespace std::chrono_literals;

constexpr auto roundInterval = 1000ms;

/// Half the idle limit, at most a second: nobody is cut off later than one and a half times the limit.
std::chrono::milliseconds roundFor(std::chrono::milliseconds idle)
{
    return idle.count() > 0 ? std::clamp<std::chrono::milliseconds>(idle / 2, 10ms, roundInterval) : roundInterval;
}

} // namespace

ClientDesk::ClientDesk(const Service &service, const DeskConfig &config, QObject *parent)
    : QObject(parent)
    , m_service(service)
    , m_config(config)
    , m_allowed(config.allow)
    , m_sentences(service.name, service.portKey)
    , m_listener(config.retry, config.acceptPause, this)
    , m_watch(this)
    , m_round(this)
{
    m_round.setInterval(roundFor(config.idle));
    connect(&m_round, &QTimer::timeout, this, &ClientDesk::lookAround);
    connect(&m_listener, &TcpListener::listening, this, &ClientDesk::onListening);
    connect(&m_listener, &TcpListener::listenFailed, this, &ClientDesk::onListenFailed);
    connect(&m_listener, &TcpListener::connected, this, &ClientDesk::onConnected);
    connect(&m_listener, &TcpListener::acceptFailed, this, [this](const QString &reason) {
        tell(JournalKind::Error, m_sentences.cannotAccept(reason));
    });
    connect(&m_listener, &TcpListener::acceptsAgain, this, [this] {
        tell(JournalKind::Info, m_sentences.acceptsAgain());
    });
}

ClientDesk::~ClientDesk()
{
    qDeleteAll(m_peers); // before the service they ask
}

bool ClientDesk::open(const QString &bind, quint16 port)
{
    m_problem.clear();
    if (!bind.isEmpty() && QHostAddress(bind).isNull()) {
        // Listening everywhere instead would serve those whom somebody meant to keep out.
        m_problem = m_sentences.badBindAddress(bind);
        tell(JournalKind::Error, m_problem);
        return false;
    }
    for (const QString &entry : m_allowed.unreadable()) {
        tell(JournalKind::Error, m_sentences.badAllowEntry(entry));
    }
    m_wantedPort = port;
    m_listener.start(bind.isEmpty() ? QHostAddress(QHostAddress::Any) : QHostAddress(bind), port);
    return true;
}

void ClientDesk::onListening()
{
    m_problem.clear();
    m_round.start();
    Q_EMIT listening();
    tell(JournalKind::On, m_sentences.listening(port()));
}

void ClientDesk::onListenFailed(QAbstractSocket::SocketError error, const QString &reason)
{
    const auto retry = std::chrono::ceil<std::chrono::seconds>(m_config.retry);
    m_problem = m_sentences.cannotListen(m_wantedPort, error, reason, retry);
    tell(JournalKind::Error, m_problem);
    Q_EMIT listenFailed();
}

void ClientDesk::close()
{
    const bool wasListening = isListening();
    m_listener.stop();
    m_round.stop();
    while (!m_peers.empty()) {
        remove(m_peers.back());
    }
    publishClients();
    if (wasListening) {
        tell(JournalKind::Off, m_sentences.stopped());
    }
}

void ClientDesk::onConnected(const Arrival &arrival)
{
    if (const QHostAddress address = plainAddress(arrival.address); !m_allowed.admits(address)) {
        ::close(arrival.descriptor);
        tellTrouble(ClientTrouble::Refused, address);
        return;
    }
    admit(arrival);
}

void ClientDesk::admit(const Arrival &arrival)
{
    makeRoom();
    auto *peer = new ClientPeer(arrival, m_service, m_watch, m_config.stall, this);
    m_peers.push_back(peer);
    connect(peer, &ClientPeer::ended, this, [this, peer](ClientPeer::End how) { onEnded(peer, how); });
    connect(peer, &ClientPeer::misspoke, this, [this, peer] {
        tellTrouble(ClientTrouble::Unanswered, peer->address());
    });
    qCDebug(logServer) << m_service.name << "client" << peer->address() << "came," << m_peers.size() << "connected";
    if (m_diary.arrives(peer->address(), SteadyTime::clock::now())) {
        tell(JournalKind::Info, m_sentences.came(peer->address()));
    }
}

void ClientDesk::makeRoom()
{
    while (m_peers.size() >= static_cast<std::size_t>(std::max(m_config.clients, 1))) {
        const auto longestIdle =
            std::min_element(m_peers.begin(), m_peers.end(), [](const ClientPeer *a, const ClientPeer *b) {
                return a->lastActive() < b->lastActive();
            });
        sendAway(*longestIdle, ClientTrouble::GaveWay);
    }
}

void ClientDesk::onEnded(ClientPeer *peer, ClientPeer::End how)
{
    switch (how) {
    case ClientPeer::End::Left: remove(peer); break;
    case ClientPeer::End::Malformed: sendAway(peer, ClientTrouble::Malformed); break;
    case ClientPeer::End::Stalled: sendAway(peer, ClientTrouble::Stalled); break;
    }
}

void ClientDesk::dismiss(const QHostAddress &address, quint16 port)
{
    const auto found = std::find_if(m_peers.begin(), m_peers.end(), [&address, port](const ClientPeer *peer) {
        return peer->port() == port && peer->address() == address;
    });
    if (found == m_peers.end()) {
        return;
    }
    remove(*found);
    tell(JournalKind::Off, m_sentences.cutOff(address, port));
    publishClients();
}

void ClientDesk::sendAway(ClientPeer *peer, ClientTrouble reason)
{
    const QHostAddress address = peer->address();
    remove(peer);
    tellTrouble(reason, address);
}

void ClientDesk::remove(ClientPeer *peer)
{
    qCDebug(logServer) << m_service.name << "client" << peer->address() << "goes after" << peer->info().requests
                       << "requests";
    std::erase(m_peers, peer);
    m_diary.leaves(peer->address(), SteadyTime::clock::now());
    peer->leave();
    peer->deleteLater();
}

void ClientDesk::lookAround()
{
    const SteadyTime now = SteadyTime::clock::now();
    sendIdleAway(now);
    for (const ClientDiary::Departure &departure : m_diary.departures(now)) {
        const auto ago = std::chrono::duration_cast<std::chrono::microseconds>(now - departure.left);
        tell(JournalKind::Info, m_sentences.gone(departure.address, utcNow() - ago));
    }
    publishClients();
}

void ClientDesk::sendIdleAway(SteadyTime now)
{
    if (m_config.idle.count() <= 0) {
        return;
    }
    const std::vector<ClientPeer *> peers = m_peers;
    for (ClientPeer *peer : peers) {
        if (now - peer->lastActive() >= m_config.idle) {
            sendAway(peer, ClientTrouble::Idle);
        }
    }
}

QList<ClientInfo> ClientDesk::clients() const
{
    QList<ClientInfo> all;
    all.reserve(static_cast<qsizetype>(m_peers.size()));
    for (const ClientPeer *peer : m_peers) {
        all.append(peer->info());
    }
    return all;
}

void ClientDesk::publishClients()
{
    static const QMetaMethod changed = QMetaMethod::fromSignal(&ClientDesk::clientsChanged);
    if (isSignalConnected(changed) && (m_hasPublished || !m_peers.empty())) {
        m_hasPublished = !m_peers.empty();
        Q_EMIT clientsChanged(clients());
    }
}

void ClientDesk::tell(JournalKind kind, const QString &text)
{
    JournalEntry entry;
    entry.kind = kind;
    entry.time = utcNow();
    entry.text = text;
    Q_EMIT journal(entry);
}

void ClientDesk::tellTrouble(ClientTrouble trouble, const QHostAddress &address)
{
    if (m_diary.isNews(trouble, address, SteadyTime::clock::now())) {
        const bool isFault = trouble == ClientTrouble::Malformed || trouble == ClientTrouble::Unanswered
            || trouble == ClientTrouble::Stalled;
        tell(isFault ? JournalKind::Error : JournalKind::Info, m_sentences.trouble(trouble, address));
    }
}

} // namespace gorizont
