#include "core/net/tcplistener.h"

#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace gorizont {

namespace {

using namespace std::chrono_literals;

constexpr int backlog = 512; ///< connections the system holds before they are accepted; the default of 50 drops some
constexpr int acceptsPerTurn = 64; ///< then those who are connected have their turn
constexpr int keepAliveIdle = 60; ///< seconds of silence before the first probe; the system's default is two hours
constexpr int keepAliveInterval = 10; ///< seconds between two probes
constexpr int keepAliveProbes = 6; ///< unanswered, then the connection is over
constexpr auto acceptCalm = 60s; ///< without a failed accept until the trouble counts as over

void setOption(int descriptor, int level, int name, int value)
{
    ::setsockopt(descriptor, level, name, &value, sizeof value);
}

/// Small answers leave at once, and a peer whose cable was pulled is noticed after two minutes.
void prepare(int descriptor)
{
    setOption(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
    setOption(descriptor, SOL_SOCKET, SO_KEEPALIVE, 1);
    setOption(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, keepAliveIdle);
    setOption(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, keepAliveInterval);
    setOption(descriptor, IPPROTO_TCP, TCP_KEEPCNT, keepAliveProbes);
}

Arrival arrival(int descriptor, const sockaddr_storage &address)
{
    const bool isIpv6 = address.ss_family == AF_INET6;
    const quint16 port = isIpv6 ? reinterpret_cast<const sockaddr_in6 *>(&address)->sin6_port
                                : reinterpret_cast<const sockaddr_in *>(&address)->sin_port;
    return {descriptor, QHostAddress(reinterpret_cast<const sockaddr *>(&address)), ntohs(port)};
}

/// Reasons to wait; everything else is about the one connection that was to be accepted (accept(2)).
bool isOutOfMeans(int error)
{
    return error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM;
}

} // namespace

TcpListener::TcpListener(std::chrono::milliseconds retry, std::chrono::milliseconds acceptPause, QObject *parent)
    : QObject(parent)
    , m_server(this)
    , m_retry(this)
    , m_acceptPause(this)
    , m_acceptCalm(this)
{
    m_server.setListenBacklogSize(backlog);
    m_retry.setInterval(retry);
    m_acceptPause.setInterval(acceptPause);
    m_acceptPause.setSingleShot(true);
    m_acceptCalm.setInterval(acceptCalm);
    m_acceptCalm.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &TcpListener::tryToListen);
    connect(&m_acceptPause, &QTimer::timeout, this, &TcpListener::resumeAccepting);
    connect(&m_acceptCalm, &QTimer::timeout, this, &TcpListener::acceptsAgain);
}

void TcpListener::start(const QHostAddress &address, quint16 port)
{
    stop();
    m_address = address;
    m_port = port;
    tryToListen();
}

void TcpListener::stop()
{
    m_retry.stop();
    m_acceptPause.stop();
    m_acceptCalm.stop();
    if (m_arrivals != nullptr) {
        m_arrivals->setEnabled(false);
        m_arrivals->deleteLater(); // this may be its own slot
        m_arrivals = nullptr;
    }
    m_server.close();
    m_lastError.reset();
}

void TcpListener::tryToListen()
{
    if (m_server.listen(m_address, m_port)) {
        m_retry.stop();
        m_lastError.reset();
        watchArrivals();
        Q_EMIT listening();
        return;
    }
    m_retry.start();
    if (m_lastError != m_server.serverError()) {
        m_lastError = m_server.serverError();
        Q_EMIT listenFailed(*m_lastError, m_server.errorString());
    }
}

void TcpListener::watchArrivals()
{
    m_server.pauseAccepting();
    m_arrivals = new QSocketNotifier(m_server.socketDescriptor(), QSocketNotifier::Read, this);
    connect(m_arrivals, &QSocketNotifier::activated, this, &TcpListener::acceptSome);
    resumeAccepting();
}

void TcpListener::acceptSome()
{
    for (int i = 0; i < acceptsPerTurn && isListening(); ++i) {
        sockaddr_storage address{};
        socklen_t size = sizeof address;
        const int descriptor = ::accept4(
            static_cast<int>(m_server.socketDescriptor()), reinterpret_cast<sockaddr *>(&address), &size,
            SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (descriptor < 0 && isOutOfMeans(errno)) {
            pauseAccepting(qt_error_string(errno));
            return;
        }
        if (descriptor < 0) {
            return; // nobody more, or somebody who has already gone
        }
        prepare(descriptor);
        Q_EMIT connected(arrival(descriptor, address));
    }
}

void TcpListener::pauseAccepting(const QString &reason)
{
    const bool isNew = !m_acceptCalm.isActive();
    m_arrivals->setEnabled(false);
    m_acceptPause.start();
    m_acceptCalm.start();
    if (isNew) {
        Q_EMIT acceptFailed(reason);
    }
}

void TcpListener::resumeAccepting()
{
    if (m_arrivals != nullptr) {
        m_arrivals->setEnabled(true);
    }
}

} // namespace gorizont
