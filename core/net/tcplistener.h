#pragma once

#include "core/net/arrival.h"

#include <QAbstractSocket>
#include <QObject>
#include <QSocketNotifier>
#include <QTcpServer>
#include <QTimer>

#include <chrono>
#include <optional>

namespace gorizont {

/// Keeps a TCP port open whatever happens: goes on trying while the port cannot be had, and while connections cannot be
/// accepted for want of descriptors. Servers thread.
/// QTcpServer listens, and accepting is done here: the engine of Qt 6.4 remembers its first error for ever, so that a
/// QTcpServer out of descriptors takes EMFILE for "nothing to accept" and spins without acceptError(), or the reverse
/// and goes deaf.
class TcpListener : public QObject
{
    Q_OBJECT

public:
    /// \a retry: between two attempts to take the port; \a acceptPause: after a connection could not be accepted.
    TcpListener(std::chrono::milliseconds retry, std::chrono::milliseconds acceptPause, QObject *parent = nullptr);

    /// The first attempt is made before this returns.
    void start(const QHostAddress &address, quint16 port);
    void stop();
    bool isListening() const { return m_server.isListening(); }
    quint16 port() const { return m_server.serverPort(); } ///< 0: not listening

Q_SIGNALS:
    void listening();
    /// Once per change of the reason.
    void listenFailed(QAbstractSocket::SocketError error, const QString &reason);
    void connected(const gorizont::Arrival &arrival);
    /// Once, until acceptsAgain().
    void acceptFailed(const QString &reason);
    void acceptsAgain();

private:
    void tryToListen();
    void acceptSome();
    void watchArrivals();
    void pauseAccepting(const QString &reason);
    void resumeAccepting();

    QTcpServer m_server;
    QSocketNotifier *m_arrivals = nullptr; ///< while listening; a child
    QHostAddress m_address;
    quint16 m_port = 0;
    QTimer m_retry;
    QTimer m_acceptPause;
    QTimer m_acceptCalm; ///< runs from the last failed accept until it counts as over
    std::optional<QAbstractSocket::SocketError> m_lastError; ///< of listening
};

} // namespace gorizont
