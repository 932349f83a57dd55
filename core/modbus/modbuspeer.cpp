#include "core/modbus/modbuspeer.h"

#include "core/modbus/allowlist.h"

#include <cstring>

namespace gorizont {

ModbusPeer::ModbusPeer(
    QTcpSocket *socket, const UnitImages &images, std::chrono::milliseconds stallLimit, QObject *parent)
    : QObject(parent)
    , m_socket(socket)
    , m_images(images)
    , m_address(plainAddress(socket->peerAddress()))
    , m_port(socket->peerPort())
    , m_stall(this)
{
    m_socket->setParent(this);
    m_socket->setReadBufferSize(readLimit);
    m_socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    m_stall.setSingleShot(true);
    m_stall.setInterval(stallLimit);
    connect(&m_stall, &QTimer::timeout, this, [this] { end(End::Stalled); });
    connect(m_socket, &QTcpSocket::readyRead, this, &ModbusPeer::readRequests);
    connect(m_socket, &QTcpSocket::bytesWritten, this, &ModbusPeer::onBytesWritten);
    connect(m_socket, &QTcpSocket::disconnected, this, [this] { end(End::Left); });
}

ModbusPeer::~ModbusPeer()
{
    leave();
}

void ModbusPeer::leave()
{
    m_isEnded = true;
    m_stall.stop();
    m_socket->abort();
}

void ModbusPeer::readRequests()
{
    if (m_isEnded || m_stall.isActive()) {
        return;
    }
    std::array<char, mbap::frameLimit + readLimit> buffer;
    std::memcpy(buffer.data(), m_rest.data(), static_cast<std::size_t>(m_restSize));
    const qint64 count = m_socket->read(buffer.data() + m_restSize, readLimit);
    if (count <= 0) {
        return;
    }
    m_bytesReceived += static_cast<quint64>(count);
    const QByteArrayView received(buffer.data(), m_restSize + count);
    AnswerBuffer answers;
    const AnsweredRequests done = answerRequests(received, m_images, answers);
    if (done.requests > 0) {
        m_requests += done.requests;
        m_exceptions += done.exceptions;
        m_lastActive = SteadyTime::clock::now();
        send(answers);
    }
    if (done.isBroken) {
        end(End::Malformed);
        return;
    }
    keepRest(received.sliced(done.consumed));
}

/// Flushes at once: a client that closes its end right after the request still gets the answer.
void ModbusPeer::send(const AnswerBuffer &answers)
{
    m_bytesSent += static_cast<quint64>(answers.size());
    m_socket->write(answers.constData(), answers.size());
    m_socket->flush();
    if (m_socket->bytesToWrite() >= unsentLimit) {
        m_stall.start();
    }
}

void ModbusPeer::keepRest(QByteArrayView rest)
{
    m_restSize = rest.size();
    std::memcpy(m_rest.data(), rest.data(), static_cast<std::size_t>(m_restSize));
}

void ModbusPeer::onBytesWritten()
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

void ModbusPeer::end(End how)
{
    if (m_isEnded) {
        return;
    }
    leave();
    Q_EMIT ended(how);
}

ModbusClientInfo ModbusPeer::info() const
{
    ModbusClientInfo info;
    info.address = m_address;
    info.port = m_port;
    info.since = m_since;
    if (m_requests > 0) {
        const auto ago = SteadyTime::clock::now() - m_lastActive;
        info.lastRequest = utcNow() - std::chrono::duration_cast<std::chrono::microseconds>(ago);
    }
    info.requests = m_requests;
    info.exceptions = m_exceptions;
    info.bytesReceived = m_bytesReceived;
    info.bytesSent = m_bytesSent;
    return info;
}

} // namespace gorizont
