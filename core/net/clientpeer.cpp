#include "core/net/clientpeer.h"

#include "core/net/allowlist.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <unistd.h>

namespace gorizont {

ClientPeer::ClientPeer(
    const Arrival &arrival, const Service &service, PeerWatch &watch, std::chrono::milliseconds stallLimit,
    QObject *parent)
    : QObject(parent)
    , m_descriptor(arrival.descriptor)
    , m_watch(watch)
    , m_service(service)
    , m_readLimit(std::clamp<qint64>(service.readLimit, 1, mostRead))
    , m_address(plainAddress(arrival.address))
    , m_port(arrival.port)
    , m_stall(this)
    , m_patience(this)
{
    m_stall.setSingleShot(true);
    m_stall.setInterval(stallLimit);
    m_patience.setSingleShot(true);
    m_patience.setInterval(service.patience);
    connect(&m_stall, &QTimer::timeout, this, [this] { end(End::Stalled); });
    connect(&m_patience, &QTimer::timeout, this, &ClientPeer::dropRest);
    if (!m_watch.add(m_descriptor, this)) {
        QMetaObject::invokeMethod(
            this, [this] { end(End::Left); }, Qt::QueuedConnection);
    }
}

ClientPeer::~ClientPeer()
{
    leave();
}

void ClientPeer::leave()
{
    m_stall.stop();
    m_patience.stop();
    if (m_descriptor >= 0) {
        m_watch.remove(m_descriptor);
        ::close(m_descriptor);
        m_descriptor = -1;
    }
}

void ClientPeer::onReady(bool isReadable, bool isWritable, bool isBroken)
{
    if (m_descriptor >= 0 && isWritable) {
        passUnsent();
    }
    if (m_descriptor >= 0 && isReadable && isReading()) {
        readRequests();
    } else if (m_descriptor >= 0 && isBroken) {
        end(End::Left);
    }
}

void ClientPeer::readRequests()
{
    std::array<char, mostKept + mostRead> buffer;
    std::memcpy(buffer.data(), m_rest.data(), static_cast<std::size_t>(m_restSize));
    if (const qint64 count = receive(buffer.data() + m_restSize); count > 0) {
        m_bytesReceived += static_cast<quint64>(count);
        answer(QByteArrayView(buffer.data(), m_restSize + count));
    }
}

/// 0: nothing to answer now or ever.
qint64 ClientPeer::receive(char *buffer)
{
    const ssize_t count = ::recv(m_descriptor, buffer, static_cast<std::size_t>(m_readLimit), 0);
    if (count > 0) {
        return count;
    }
    if (count == 0 && !m_unsent.isEmpty()) {
        m_isAtEnd = true;
        m_stall.start();
        chooseWhen();
    } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
        end(End::Left);
    }
    return 0;
}

void ClientPeer::answer(QByteArrayView received)
{
    AnswerBuffer answers;
    const AnsweredRequests done = m_service.answer(received, answers);
    m_requests += done.requests;
    m_errors += done.exceptions + done.unanswered;
    if (done.requests > 0) {
        m_lastActive = SteadyTime::clock::now();
        send(answers);
    }
    if (m_descriptor < 0) {
        return; // the connection broke while the answers were sent
    }
    if (done.isBroken || !keepRest(received.sliced(done.consumed))) {
        end(End::Malformed);
        return;
    }
    if (done.unanswered > 0) {
        Q_EMIT misspoke();
    }
}

void ClientPeer::send(QByteArrayView answers)
{
    m_bytesSent += static_cast<quint64>(answers.size());
    const qsizetype taken = m_unsent.isEmpty() ? pass(answers) : 0;
    if (m_descriptor < 0 || taken == answers.size()) {
        return;
    }
    m_unsent.append(answers.sliced(taken));
    if (m_unsent.size() >= unsentLimit) {
        m_stall.start();
    }
    chooseWhen();
}

/// How many of the bytes the system has taken; the connection may be over afterwards.
qsizetype ClientPeer::pass(QByteArrayView bytes)
{
    const ssize_t taken = ::send(m_descriptor, bytes.data(), static_cast<std::size_t>(bytes.size()), MSG_NOSIGNAL);
    if (taken < 0 && errno != EAGAIN && errno != EINTR) {
        end(End::Left);
    }
    return std::max<qsizetype>(taken, 0);
}

void ClientPeer::passUnsent()
{
    m_unsent.remove(0, pass(m_unsent));
    if (m_descriptor < 0) {
        return;
    }
    if (m_isAtEnd && m_unsent.isEmpty()) {
        end(End::Left);
        return;
    }
    if (m_isAtEnd || (m_stall.isActive() && m_unsent.size() > unsentLimit / 2)) {
        m_stall.start();
    } else {
        m_stall.stop();
    }
    chooseWhen();
}

void ClientPeer::chooseWhen()
{
    m_watch.choose(m_descriptor, this, isReading(), !m_unsent.isEmpty());
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
    if (!isReading()) {
        m_patience.start(); // the continuation may have come, it is we who do not read
        return;
    }
    m_restSize = 0;
    ++m_errors;
    Q_EMIT misspoke();
}

void ClientPeer::end(End how)
{
    if (m_descriptor < 0) {
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
