#include "tests/core/mqtt/toybroker.h"

#include <utility>

namespace gorizont::test {

namespace {

int big16(const QByteArray &bytes, qsizetype at)
{
    return static_cast<uchar>(bytes.at(at)) * 256 + static_cast<uchar>(bytes.at(at + 1));
}

/// A string with its length before it; \a at moves behind it.
QByteArray field(const QByteArray &bytes, qsizetype &at)
{
    const int size = big16(bytes, at);
    at += 2 + size;
    return bytes.mid(at - size, size);
}

QByteArray withNumber(char type, int number)
{
    QByteArray packet(4, '\0');
    packet[0] = type;
    packet[1] = 2;
    packet[2] = static_cast<char>(number >> 8);
    packet[3] = static_cast<char>(number & 0xFF);
    return packet;
}

} // namespace

ToyBroker::ToyBroker()
{
    connect(&m_server, &QTcpServer::newConnection, this, &ToyBroker::takeConnection);
}

bool ToyBroker::listen()
{
    const bool isListening = m_server.listen(QHostAddress::LocalHost, m_port);
    m_port = m_server.serverPort();
    return isListening;
}

void ToyBroker::stop()
{
    m_server.close();
    disconnectAll();
}

void ToyBroker::disconnectAll()
{
    const QList<QTcpSocket *> sockets = m_buffers.keys();
    for (QTcpSocket *socket : sockets) {
        m_buffers.remove(socket);
        socket->abort();
        socket->deleteLater();
    }
}

QByteArrayList ToyBroker::payloads(const QByteArray &topic) const
{
    QByteArrayList found;
    for (const Publish &publish : publishes) {
        if (publish.topic == topic) {
            found.append(publish.payload);
        }
    }
    return found;
}

void ToyBroker::takeConnection()
{
    while (QTcpSocket *socket = m_server.nextPendingConnection()) {
        m_buffers.insert(socket, {});
        if (reads) {
            connect(socket, &QTcpSocket::readyRead, this, [this, socket] { take(socket); });
            take(socket);
        } else {
            socket->setReadBufferSize(1);
        }
    }
}

void ToyBroker::take(QTcpSocket *socket)
{
    if (!m_buffers.contains(socket)) {
        return;
    }
    QByteArray buffer = m_buffers.value(socket) + socket->readAll();
    while (m_buffers.contains(socket) && takePacket(socket, buffer)) {
    }
    if (m_buffers.contains(socket)) {
        m_buffers[socket] = buffer;
    }
}

/// MQTT 3.1.1, section 2.2: type and flags, length in seven bits a byte, body.
bool ToyBroker::takePacket(QTcpSocket *socket, QByteArray &buffer)
{
    qsizetype length = 0;
    qsizetype at = 1;
    for (int shift = 0;; shift += 7, ++at) {
        if (at >= buffer.size()) {
            return false;
        }
        length += static_cast<qsizetype>(buffer.at(at) & 0x7F) << shift;
        if ((buffer.at(at) & 0x80) == 0) {
            break;
        }
    }
    if (buffer.size() < at + 1 + length) {
        return false;
    }
    const int first = static_cast<uchar>(buffer.at(0));
    const QByteArray body = buffer.mid(at + 1, length);
    buffer.remove(0, at + 1 + length);
    switch (first >> 4) {
    case 1: takeConnect(socket, body); break;
    case 3: takePublish(socket, first & 0x0F, body); break;
    case 12: socket->write(QByteArray::fromHex("d000")); break; // PINGREQ
    default: break;
    }
    return true;
}

/// Section 3.1: protocol name, level, flags, keep-alive; then client, will topic, will, user, password.
void ToyBroker::takeConnect(QTcpSocket *socket, const QByteArray &body)
{
    qsizetype at = 0;
    field(body, at);
    const int flags = static_cast<uchar>(body.at(at + 1));
    at += 4;
    Connect seen;
    seen.client = field(body, at);
    if (flags & 0x04) {
        seen.willTopic = field(body, at);
        seen.will = field(body, at);
        seen.isWillRetained = flags & 0x20;
    }
    if (flags & 0x80) {
        seen.user = field(body, at);
    }
    if (flags & 0x40) {
        seen.password = field(body, at);
    }
    connects.append(seen);
    if (answersConnect) {
        socket->write(withNumber(0x20, connackCode));
    }
}

/// Section 3.3: topic, number if QoS > 0, payload.
void ToyBroker::takePublish(QTcpSocket *socket, int flags, const QByteArray &body)
{
    qsizetype at = 0;
    Publish seen;
    seen.topic = field(body, at);
    seen.qos = (flags >> 1) & 3;
    seen.isRetained = flags & 1;
    const int number = seen.qos > 0 ? big16(body, at) : 0;
    seen.payload = body.mid(at + (seen.qos > 0 ? 2 : 0));
    publishes.append(seen);
    if (endsAfter >= 0 && endsAfter-- == 0) {
        disconnectAll();
    } else if (seen.qos == 1 && acknowledges) {
        socket->write(withNumber(0x40, number));
    } else if (seen.qos == 1) {
        ++unacknowledged;
    }
}

} // namespace gorizont::test
