#include "core/station/service/tcpdoor.h"

#include <QTcpSocket>

#include <algorithm>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto reopenPause = 5s;
constexpr auto acceptPause = 1s; ///< out of descriptors: accepting at once again would spin (spec/traps.md, 11)
constexpr qint64 mostUnsent = 262'144; ///< bytes
constexpr qint64 mostRead = 131'072; ///< bytes at once: a whole file and what follows
constexpr auto byteTime = 1ms; ///< of a slow mobile link

} // namespace

TcpDoor::TcpDoor(const QHostAddress &address, quint16 port, Answerer answerer, QObject *parent)
    : QObject(parent)
    , m_address(address)
    , m_wantedPort(port)
    , m_answerer(std::move(answerer))
{
    m_retry.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &TcpDoor::open);
    connect(&m_server, &QTcpServer::newConnection, this, &TcpDoor::onConnection);
    connect(&m_server, &QTcpServer::acceptError, this, &TcpDoor::pauseAccepting);
}

/// Sockets that end with the server must find no client to remove any more.
TcpDoor::~TcpDoor()
{
    for (auto client = m_clients.keyBegin(); client != m_clients.keyEnd(); ++client) {
        (*client)->disconnect(this);
    }
}

void TcpDoor::open()
{
    const QString name = QStringLiteral("%1:%2").arg(m_address.toString()).arg(m_wantedPort);
    if (m_server.listen(m_address, m_wantedPort)) {
        m_isTold = false;
        Q_EMIT stateChanged(true, tr("TCP %1:%2: open for dispatchers").arg(m_address.toString()).arg(port()));
        return;
    }
    m_retry.start(reopenPause);
    if (!m_isTold) {
        m_isTold = true;
        Q_EMIT stateChanged(
            false,
            tr("TCP %1 is closed for dispatchers (%2) and is tried again and again").arg(name, m_server.errorString()));
    }
}

void TcpDoor::pauseAccepting()
{
    m_server.pauseAccepting();
    QTimer::singleShot(acceptPause, this, [this] { m_server.resumeAccepting(); });
}

void TcpDoor::onConnection()
{
    while (QTcpSocket *socket = m_server.nextPendingConnection()) {
        makeRoom();
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        socket->setReadBufferSize(mostRead);
        m_clients.insert(socket, {RequestListener(m_answerer.isOwn, byteTime), std::chrono::steady_clock::now()});
        connect(socket, &QTcpSocket::readyRead, this, [this, socket] { onBytes(socket); });
        connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
            m_clients.remove(socket);
            socket->deleteLater();
        });
        onBytes(socket);
    }
}

void TcpDoor::makeRoom()
{
    if (m_clients.size() < mostClients) {
        return;
    }
    const auto idlest = std::min_element(m_clients.begin(), m_clients.end(), [](const Client &a, const Client &b) {
        return a.heard < b.heard;
    });
    idlest.key()->abort();
}

void TcpDoor::onBytes(QTcpSocket *socket)
{
    const auto client = m_clients.find(socket);
    if (client == m_clients.end()) {
        return;
    }
    const QByteArray bytes = socket->read(mostRead);
    client->heard = std::chrono::steady_clock::now();
    const QList<ack::Asked> requests = client->listener.hear(bytes, client->heard);
    for (const ack::Asked &asked : requests) {
        socket->write(m_answerer.answer(asked));
        if (socket->bytesToWrite() > mostUnsent) {
            socket->abort();
            return;
        }
    }
    socket->flush();
}

} // namespace gorizont::station
