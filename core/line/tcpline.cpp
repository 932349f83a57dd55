#include "core/line/tcpline.h"

namespace gorizont {

namespace {

using namespace std::chrono_literals;

/// A device server that does not accept within this time is off.
constexpr auto connectLimit = 3000ms;

} // namespace

TcpLine::TcpLine(const QString &host, quint16 port, std::chrono::milliseconds pauseTick)
    : Line(pauseTick)
    , m_host(host)
    , m_port(port)
{
}

TcpLine::~TcpLine()
{
    m_socket.abort();
}

Result<void> TcpLine::open()
{
    m_socket.abort();
    m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket.connectToHost(m_host, m_port);
    const QDeadlineTimer deadline(connectLimit);
    while (m_socket.state() != QAbstractSocket::ConnectedState) {
        if (m_socket.waitForConnected(sliceUntil(deadline))) {
            break;
        }
        if (isInterrupted()) {
            m_socket.abort();
            return Fault::Cancelled;
        }
        if (m_socket.error() != QAbstractSocket::SocketTimeoutError || deadline.hasExpired()) {
            return closeBroken();
        }
    }
    m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    return {};
}

void TcpLine::close()
{
    m_socket.abort();
}

bool TcpLine::isOpen() const
{
    return m_socket.state() == QAbstractSocket::ConnectedState;
}

Result<void> TcpLine::writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout)
{
    if (!isOpen()) {
        return Fault::Closed;
    }
    m_socket.write(bytes.data(), bytes.size());
    const QDeadlineTimer deadline(timeout);
    while (m_socket.bytesToWrite() > 0) {
        // Half a request may be under way; what follows it would be misread, so the connection ends either way.
        if (isInterrupted()) {
            m_socket.abort();
            return Fault::Cancelled;
        }
        const bool isGoingOn = m_socket.waitForBytesWritten(sliceUntil(deadline))
            || m_socket.error() == QAbstractSocket::SocketTimeoutError;
        if (!isGoingOn || deadline.hasExpired()) {
            return closeBroken();
        }
    }
    return {};
}

Result<QByteArray> TcpLine::readSome(std::chrono::microseconds timeout)
{
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(timeout);
    if (m_socket.bytesAvailable() == 0) {
        m_socket.waitForReadyRead(static_cast<int>(wait.count()));
    }
    QByteArray bytes = m_socket.readAll();
    if (bytes.isEmpty() && !isOpen()) {
        return closeBroken();
    }
    return bytes;
}

Fault TcpLine::closeBroken()
{
    setLastError(m_socket.error(), m_socket.errorString());
    m_socket.abort();
    return Fault::Closed;
}

} // namespace gorizont
