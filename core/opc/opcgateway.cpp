#include "core/opc/opcgateway.h"

#include "core/net/allowlist.h"

#include <numeric>

namespace gorizont {

namespace {

constexpr int systemBuffer = 65536; ///< bytes: what lies in the system cannot be replaced by newer values
constexpr qint64 mostRead = 16384; ///< bytes a turn

} // namespace

OpcGateway::OpcGateway(
    QTcpSocket *socket, const OpcImage &image, const OpcOpening &opening, const Pace &pace, QObject *parent)
    : QObject(parent)
    , m_socket(socket)
    , m_image(image)
    , m_opening(opening)
    , m_pace(pace)
    , m_silence(this)
    , m_isWaiting(static_cast<std::size_t>(image.tags().size()), 0)
{
    m_info.address = plainAddress(socket->peerAddress());
    m_info.port = socket->peerPort();
    m_info.since = utcNow();
    m_socket->setParent(this);
    m_socket->setReadBufferSize(mostRead);
    m_socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    m_socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, systemBuffer);
    connect(m_socket, &QTcpSocket::readyRead, this, &OpcGateway::receive);
    connect(m_socket, &QTcpSocket::bytesWritten, this, &OpcGateway::onTaken);
    connect(m_socket, &QTcpSocket::disconnected, this, [this] { end(End::Left); });
    m_silence.setInterval(pace.ping);
    connect(&m_silence, &QTimer::timeout, this, &OpcGateway::onSilence);
    m_silence.start();
    m_queue.resize(m_isWaiting.size());
    std::iota(m_queue.begin(), m_queue.end(), 0);
    std::fill(m_isWaiting.begin(), m_isWaiting.end(), 1);
    QMetaObject::invokeMethod(this, &OpcGateway::pump, Qt::QueuedConnection);
}

void OpcGateway::note(const std::vector<int> &changed)
{
    for (const int index : changed) {
        char &isWaiting = m_isWaiting[static_cast<std::size_t>(index)];
        if (isWaiting == 0) {
            isWaiting = 1;
            m_queue.push_back(index);
        }
    }
}

void OpcGateway::passChanges()
{
    pump();
}

void OpcGateway::pump()
{
    while (!m_hasEnded && hasRoom()) {
        const QByteArray line = nextLine();
        if (line.isEmpty()) {
            return;
        }
        send(line);
    }
}

/// Empty: nothing waits.
QByteArray OpcGateway::nextLine()
{
    if (m_openingLine > m_opening.tags.size()) {
        return nextValues();
    }
    const qsizetype line = m_openingLine++;
    if (line < 0) {
        return m_opening.hello;
    }
    return line < m_opening.tags.size() ? m_opening.tags.at(line) : opclines::ready();
}

QByteArray OpcGateway::nextValues()
{
    const std::size_t count = std::min<std::size_t>(m_queue.size() - m_queueStart, opclines::mostValues);
    if (count == 0) {
        return {};
    }
    QByteArray line = opclines::beginValues();
    for (std::size_t i = 0; i < count; ++i) {
        const int index = m_queue[m_queueStart + i];
        m_isWaiting[static_cast<std::size_t>(index)] = 0;
        opclines::appendValue(line, index, m_image.sample(index));
    }
    opclines::endValues(line);
    m_queueStart += count;
    if (m_queueStart == m_queue.size() || m_queueStart >= m_isWaiting.size()) {
        m_queue.erase(m_queue.begin(), m_queue.begin() + static_cast<std::ptrdiff_t>(m_queueStart));
        m_queueStart = 0;
    }
    return line;
}

void OpcGateway::send(const QByteArray &line)
{
    if (m_socket->bytesToWrite() == 0) {
        m_lastTaken = SteadyTime::clock::now(); // nothing waited until now
    }
    m_info.bytesSent += static_cast<quint64>(line.size());
    m_socket->write(line);
    m_silence.start();
}

void OpcGateway::onTaken()
{
    m_lastTaken = SteadyTime::clock::now();
    pump();
}

void OpcGateway::onSilence()
{
    if (m_socket->bytesToWrite() == 0) {
        send(opclines::ping());
    } else if (SteadyTime::clock::now() - m_lastTaken >= m_pace.stall) {
        end(End::Stalled);
    }
}

void OpcGateway::receive()
{
    const QByteArray received = m_socket->read(mostRead);
    m_info.bytesReceived += static_cast<quint64>(received.size());
    m_rest += received;
    qsizetype start = 0;
    for (qsizetype at = m_rest.indexOf('\n'); at >= 0 && at - start <= opclines::mostReceived;
         at = m_rest.indexOf('\n', start)) {
        takeLine(QByteArrayView(m_rest).sliced(start, at - start));
        start = at + 1;
    }
    m_rest.remove(0, start);
    if (m_rest.size() > opclines::mostReceived) {
        end(End::Malformed);
    }
}

void OpcGateway::takeLine(QByteArrayView line)
{
    const auto greeting = m_hasGreeted ? std::nullopt : opclines::greeting(line);
    if (!greeting) {
        ++m_info.errors;
        return;
    }
    m_hasGreeted = true;
    ++m_info.requests;
    m_info.lastRequest = utcNow();
    Q_EMIT greeted(*greeting);
}

void OpcGateway::sayGoodbye()
{
    if (!m_hasEnded && m_openingLine >= 0) {
        send(opclines::end());
        m_socket->flush();
    }
    leave();
}

void OpcGateway::leave()
{
    m_hasEnded = true;
    m_silence.stop();
    m_socket->disconnect(this);
    m_socket->abort(); // what the system has taken still arrives
}

void OpcGateway::end(End how)
{
    if (!m_hasEnded) {
        leave();
        Q_EMIT ended(how);
    }
}

} // namespace gorizont
