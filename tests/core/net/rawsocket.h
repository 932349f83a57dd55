#pragma once

#include <QByteArray>

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace gorizont::test {

/// A bare non-blocking socket for what QTcpSocket is too polite to do: never read, keep a descriptor for later.
class RawSocket
{
public:
    RawSocket()
        : m_fd(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0))
    {
    }
    ~RawSocket() { close(); }
    RawSocket(const RawSocket &) = delete;
    RawSocket &operator=(const RawSocket &) = delete;

    int fd() const { return m_fd; }

    void setReceiveBuffer(int bytes) { ::setsockopt(m_fd, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes); }

    /// The other end gets a reset instead of an end.
    void resetOnClose()
    {
        const linger hard{1, 0};
        ::setsockopt(m_fd, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
    }

    /// To 127.0.0.1; whether the connection is made or on its way.
    bool connect(quint16 port)
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return ::connect(m_fd, reinterpret_cast<const sockaddr *>(&address), sizeof address) == 0
            || errno == EINPROGRESS;
    }

    /// How many bytes were taken; 0: none now; −1: the connection is gone.
    ssize_t send(const QByteArray &bytes)
    {
        const ssize_t count = ::send(m_fd, bytes.constData(), static_cast<std::size_t>(bytes.size()), MSG_NOSIGNAL);
        return count < 0 && errno == EAGAIN ? 0 : count;
    }

    QByteArray receive(qsizetype most = 65536)
    {
        QByteArray bytes(most, '\0');
        const ssize_t count = ::recv(m_fd, bytes.data(), static_cast<std::size_t>(most), 0);
        return bytes.first(std::max<qsizetype>(count, 0));
    }

    /// Sends no more, and still reads.
    void finish() { ::shutdown(m_fd, SHUT_WR); }

    /// The other end has closed or reset the connection. Consumes nothing but the news.
    bool isGone()
    {
        char byte = 0;
        const ssize_t count = ::recv(m_fd, &byte, 1, MSG_PEEK);
        return count == 0 || (count < 0 && errno != EAGAIN);
    }

    void close()
    {
        if (m_fd >= 0) {
            ::close(m_fd);
        }
        m_fd = -1;
    }

private:
    int m_fd;
};

/// A second descriptor of the server's end of the one connection to \a port, as a process has that was started while the
/// client was connected; −1: there is no such connection in this process.
inline int holdServerEnd(quint16 port)
{
    for (int fd = 3; fd < 1024; ++fd) {
        sockaddr_in own{};
        sockaddr_in other{};
        socklen_t ownSize = sizeof own;
        socklen_t otherSize = sizeof other;
        if (::getsockname(fd, reinterpret_cast<sockaddr *>(&own), &ownSize) == 0 && own.sin_port == htons(port)
            && ::getpeername(fd, reinterpret_cast<sockaddr *>(&other), &otherSize) == 0) {
            return ::dup(fd);
        }
    }
    return -1;
}

} // namespace gorizont::test
