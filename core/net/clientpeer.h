#pragma once

#include "core/net/arrival.h"
#include "core/net/clientinfo.h"
#include "core/net/peerwatch.h"
#include "core/net/service.h"

#include <QByteArray>
#include <QObject>
#include <QTimer>

#include <array>

namespace gorizont {

/// The server's end of one connection: bytes in, answers out. Servers thread.
/// One bounded read a turn, all its requests answered by one write. A part of a request waits in a fixed buffer. A
/// client that does not take its answers is not read any further once unsentLimit bytes wait for it, and reported as
/// Stalled when it then takes nothing for a while. One that has closed its end still gets what it asked for.
class ClientPeer : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 mostRead = 4096; ///< bytes a turn: 341 reads of Modbus at most, 88 KiB of answers
    static constexpr qsizetype mostKept = 512; ///< bytes: no request may be longer
    static constexpr qint64 unsentLimit = 262144; ///< bytes, 256 KiB

    enum class End : quint8 { Left, Malformed, Stalled };
    Q_ENUM(End)

    /// \a service and \a watch must outlive the peer.
    ClientPeer(
        const Arrival &arrival, const Service &service, PeerWatch &watch, std::chrono::milliseconds stallLimit,
        QObject *parent = nullptr);
    ~ClientPeer() override;

    const QHostAddress &address() const { return m_address; } ///< plainAddress()
    quint16 port() const { return m_port; } ///< of the client
    SteadyTime lastActive() const { return m_lastActive; } ///< the last answered request, or the connection itself
    ClientInfo info() const;

    /// For PeerWatch. \a isBroken: nothing can be sent any more.
    void onReady(bool isReadable, bool isWritable, bool isBroken);
    /// Ends the connection without ended(). What the system has taken for sending still arrives.
    void leave();

Q_SIGNALS:
    /// The client sent something that gets no answer; it stays connected.
    void misspoke();
    /// Once, from inside a slot of the peer: delete it later.
    void ended(gorizont::ClientPeer::End end);

private:
    bool isReading() const { return !m_stall.isActive() && !m_isAtEnd; }
    void readRequests();
    qint64 receive(char *buffer);
    void answer(QByteArrayView received);
    void send(QByteArrayView answers);
    qsizetype pass(QByteArrayView bytes);
    void passUnsent();
    void chooseWhen();
    bool keepRest(QByteArrayView rest);
    void dropRest();
    void end(End how);

    int m_descriptor; ///< −1: ended
    PeerWatch &m_watch;
    const Service &m_service;
    const qint64 m_readLimit;
    QHostAddress m_address;
    quint16 m_port = 0;
    QTimer m_stall; ///< runs while the client is not read for its unsent answers
    QTimer m_patience; ///< runs while a part of a request waits, if that is limited
    std::array<char, mostKept> m_rest{}; ///< the start of a request
    qsizetype m_restSize = 0;
    QByteArray m_unsent; ///< answers that the system has not taken yet
    bool m_isAtEnd = false; ///< the client sends no more
    UtcTime m_since = utcNow();
    SteadyTime m_lastActive = SteadyTime::clock::now();
    quint64 m_requests = 0;
    quint64 m_errors = 0;
    quint64 m_bytesReceived = 0;
    quint64 m_bytesSent = 0;
};

} // namespace gorizont
