#pragma once

#include "core/modbus/modbusanswer.h"
#include "core/protocol/mbap.h"

#include <QHostAddress>
#include <QObject>
#include <QTcpSocket>
#include <QTimer>

#include <array>
#include <optional>

namespace gorizont {

/// One connected client as the clients page shows it.
struct ModbusClientInfo
{
    QHostAddress address;
    quint16 port = 0; ///< of the client
    UtcTime since; ///< when it connected
    std::optional<UtcTime> lastRequest; ///< empty: none so far
    quint64 requests = 0;
    quint64 exceptions = 0; ///< requests answered with an exception
    quint64 bytesReceived = 0;
    quint64 bytesSent = 0;

    bool operator==(const ModbusClientInfo &) const = default;
};

/// The server's end of one connection: bytes in, answers out. Servers thread.
/// One bounded read a turn, all its requests answered by one write. Half a request waits in a fixed buffer. A client
/// that does not take its answers is not read any further once unsentLimit bytes wait for it, and reported as Stalled
/// when it then takes nothing for a while.
class ModbusPeer : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 readLimit = 4096; ///< bytes a turn: at most 341 reads, 88 KiB of answers
    static constexpr qint64 unsentLimit = 262144; ///< bytes, 256 KiB

    enum class End : quint8 { Left, Malformed, Stalled };
    Q_ENUM(End)

    /// Takes over \a socket, which is connected. \a images must outlive the peer.
    ModbusPeer(
        QTcpSocket *socket, const UnitImages &images, std::chrono::milliseconds stallLimit, QObject *parent = nullptr);
    ~ModbusPeer() override;

    const QHostAddress &address() const { return m_address; } ///< plainAddress()
    SteadyTime lastActive() const { return m_lastActive; } ///< the last request, or the connection itself
    ModbusClientInfo info() const;

    /// Ends the connection without ended(). What the system has taken for sending still arrives.
    void leave();

Q_SIGNALS:
    /// Once, from inside a slot of the peer: delete it later.
    void ended(gorizont::ModbusPeer::End end);

private:
    void readRequests();
    void send(const AnswerBuffer &answers);
    void keepRest(QByteArrayView rest);
    void onBytesWritten();
    void end(End how);

    QTcpSocket *m_socket;
    const UnitImages &m_images;
    QHostAddress m_address;
    quint16 m_port = 0;
    QTimer m_stall; ///< runs while the client is not read
    std::array<char, mbap::frameLimit> m_rest{}; ///< the start of a request
    qsizetype m_restSize = 0;
    bool m_isEnded = false;
    UtcTime m_since = utcNow();
    SteadyTime m_lastActive = SteadyTime::clock::now();
    quint64 m_requests = 0;
    quint64 m_exceptions = 0;
    quint64 m_bytesReceived = 0;
    quint64 m_bytesSent = 0;
};

} // namespace gorizont
