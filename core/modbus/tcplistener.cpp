#include "core/modbus/tcplistener.h"

#include <QTcpSocket>

namespace gorizont {

namespace {

using namespace std::chrono_literals;

constexpr int backlog = 512; ///< connections the system holds before they are accepted; the default of 50 drops some
constexpr auto acceptCalm = 60s; ///< without a failed accept until the trouble counts as over

} // namespace

TcpListener::TcpListener(std::chrono::milliseconds retry, std::chrono::milliseconds acceptPause, QObject *parent)
    : QObject(parent)
    , m_server(this)
    , m_retry(this)
    , m_acceptPause(this)
    , m_acceptCalm(this)
{
    m_server.setListenBacklogSize(backlog);
    m_server.setMaxPendingConnections(backlog);
    m_retry.setInterval(retry);
    m_acceptPause.setInterval(acceptPause);
    m_acceptPause.setSingleShot(true);
    m_acceptCalm.setInterval(acceptCalm);
    m_acceptCalm.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &TcpListener::tryToListen);
    connect(&m_acceptPause, &QTimer::timeout, &m_server, &QTcpServer::resumeAccepting);
    connect(&m_acceptCalm, &QTimer::timeout, this, &TcpListener::acceptsAgain);
    connect(&m_server, &QTcpServer::acceptError, this, &TcpListener::onAcceptError);
    connect(&m_server, &QTcpServer::newConnection, this, [this] {
        while (QTcpSocket *socket = m_server.nextPendingConnection()) {
            Q_EMIT connected(socket);
        }
    });
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
    m_server.close();
    m_lastError.reset();
}

void TcpListener::tryToListen()
{
    if (m_server.listen(m_address, m_port)) {
        m_retry.stop();
        m_lastError.reset();
        Q_EMIT listening();
        return;
    }
    m_retry.start();
    if (m_lastError != m_server.serverError()) {
        m_lastError = m_server.serverError();
        Q_EMIT listenFailed(*m_lastError, m_server.errorString());
    }
}

void TcpListener::onAcceptError()
{
    const bool isNew = !m_acceptCalm.isActive();
    m_acceptPause.start();
    m_acceptCalm.start();
    if (isNew) {
        Q_EMIT acceptFailed(m_server.errorString());
    }
}

} // namespace gorizont
