#include "core/net/clientpeer.h"

#include "core/net/allowlist.h"

#include <algorithm>
#include <cstring>

namespace gorizont {

ClientPeer::ClientPeer(
    QTcpSocket *socket, const Service &service, std::chrono::milliseconds stallLimit, QObject *parent)
    : QObject(parent)
    , m_socket(socket)
    , m_service(service)
    , m_readLimit(std::clamp<qint64>(service.readLimit, 1, mostRead))
    , m_address(plainAddress(socket->peerAddress()))
    , m_port(socket->peerPort())
    , m_stall(this)
    , m_patience(this)
{
    m_socket->setParent(this);
    m_socket->setReadBufferSize(m_readLimit);
    m_stall.setSingleShot(true);
    m_stall.setInterval(stallLimit);
    m_patience.setSingleShot(true);
    m_patience.setInterval(service.patience);
    connect(&m_stall, &QTimer::timeout, this, [this] { end(End::Stalled); });
    connect(&m_patience, &QTimer::timeout, this, &ClientPeer::dropRest);
    connect(m_socket, &QTcpSocket::readyRead, this, &ClientPeer::readRequests);
    connect(m_socket, &QTcpSocket::bytesWritten, this, &ClientPeer::onBytesWritten);
    connect(m_socket, &QTcpSocket::disconnected, this, [this] { end(End::Left); });
}

ClientPeer::~ClientPeer()
{
    leave();
}

void ClientPeer::leave()
{
    m_isEnded = true;
    m_stall.stop();
    m_patience.stop();
    m_socket->abort();
}

void ClientPeer::readRequests()
{
    if (m_isEnded || m_stall.isActive()) {
        return;
    }
    std::array<char, mostKept + mostRead> buffer;
    std::memcpy(buffer.data(), m_rest.data(), static_cast<std::size_t>(m_restSize));
    const qint64 count = m_socket->read(buffer.data() + m_restSize, m_readLimit);
    if (count <= 0) {
        return;
    }
    m_bytesReceived += static_cast<quint64>(count);
    const QByteArrayView received(buffer.data(), m_restSize + count);
    AnswerBuffer answers;
    const AnsweredRequests done = m_service.answer(received, answers);
    m_requests += done.requests;
    m_errors += done.exceptions + done.unanswered;
    if (done.requests > 0) {
        m_lastActive = SteadyTime::clock::now();
        send(answers);
    }
    if (m_isEnded) {
        return; // the connection broke while the answers were written
    }
    if (done.isBroken || !keepRest(received.sliced(done.consumed))) {
        end(End::Malformed);
        return;
    }
    if (done.unanswered > 0) {
        Q_EMIT misspoke();
    }
}

/// Flushes at once: a client that closes its end right after the request still gets the answer.
void ClientPeer::send(const AnswerBuffer &answers)
{
    m_bytesSent += static_cast<quint64>(answers.size());
    m_socket->write(answers.constData(), answers.size());
    m_socket->flush();
    if (m_socket->bytesToWrite() >= unsentLimit) {
        m_stall.start();
    }
}

/// False: \a rest is longer than any request.
bool ClientPeer::keepRest(QByteArrayView rest)
{
    if (rest.size() > mostKept) {
        return false;
    }
    m_restSize = rest.size();
    std::memcpy(m_rest.data(), rest.data(), static_cast<std::size_t>(m_restSize));
    if (m_service.patience.count() <= 0) {
        return true;
    }
    if (m_restSize > 0) {
        m_patience.start();
    } else {
        m_patience.stop();
    }
    return true;
}

void ClientPeer::dropRest()
{
    if (m_stall.isActive()) {
        m_patience.start(); // the continuation may have come, it is we who do not read
        return;
    }
    m_restSize = 0;
    ++m_errors;
    Q_EMIT misspoke();
}

void ClientPeer::onBytesWritten()
{
    if (!m_stall.isActive()) {
        return;
    }
    if (m_socket->bytesToWrite() > unsentLimit / 2) {
        m_stall.start();
        return;
    }
    m_stall.stop();
    readRequests();
}

void ClientPeer::end(End how)
{
    if (m_isEnded) {
        return;
    }
    leave();
    Q_EMIT ended(how);
}

ClientInfo ClientPeer::info() const
{
    ClientInfo info;
    info.address = m_address;
    info.port = m_port;
    info.since = m_since;
    if (m_requests > 0) {
        const auto ago = SteadyTime::clock::now() - m_lastActive;
        info.lastRequest = utcNow() - std::chrono::duration_cast<std::chrono::microseconds>(ago);
    }
    info.requests = m_requests;
    info.errors = m_errors;
    info.bytesReceived = m_bytesReceived;
    info.bytesSent = m_bytesSent;
    return info;
}

} // namespace gorizont
