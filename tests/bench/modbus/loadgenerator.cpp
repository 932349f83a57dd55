#include "tests/bench/modbus/loadgenerator.h"

#include "tests/bench/modbus/payload.h"

#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace gorizont::bench {

namespace {

constexpr std::array<std::uint8_t, requestSize> request = {0, 0, 0, 0, 0, 6, unit, 4, 0, 0, 0, registerCount};

/// The answer of the specification, without its transaction.
constexpr std::array<std::uint8_t, answerSize> expectedAnswer()
{
    std::array<std::uint8_t, answerSize> answer{0, 0, 0, 0, 0, answerSize - 6, unit, 4, payloadSize};
    const auto registers = payload();
    for (std::size_t i = 0; i < registers.size(); ++i) {
        answer[9 + i] = registers[i];
    }
    return answer;
}

} // namespace

LoadGenerator::LoadGenerator(int port, int connections, int inFlight)
    : m_poll(::epoll_create1(0))
    , m_inFlight(inFlight)
    , m_connections(static_cast<std::size_t>(connections))
{
    for (Connection &connection : m_connections) {
        connectOne(port, connection);
    }
}

LoadGenerator::~LoadGenerator()
{
    for (const Connection &connection : m_connections) {
        ::close(connection.descriptor);
    }
    ::close(m_poll);
}

void LoadGenerator::connectOne(int port, Connection &connection)
{
    connection.descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(connection.descriptor, reinterpret_cast<const sockaddr *>(&address), sizeof address) != 0) {
        m_hasFailed = true;
        return;
    }
    const int noDelay = 1;
    ::setsockopt(connection.descriptor, IPPROTO_TCP, TCP_NODELAY, &noDelay, sizeof noDelay);
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.ptr = &connection;
    ::epoll_ctl(m_poll, EPOLL_CTL_ADD, connection.descriptor, &event);
}

std::uint64_t LoadGenerator::run(std::chrono::duration<double> duration)
{
    const auto end = std::chrono::steady_clock::now() + duration;
    const std::uint64_t before = m_answers;
    if (!m_isStarted) {
        m_isStarted = true;
        for (Connection &connection : m_connections) {
            ask(connection, m_inFlight);
        }
    }
    while (!m_hasFailed && std::chrono::steady_clock::now() < end) {
        std::array<epoll_event, 64> events{};
        const int count = ::epoll_wait(m_poll, events.data(), static_cast<int>(events.size()), 100);
        for (int i = 0; i < count; ++i) {
            receive(*static_cast<Connection *>(events[static_cast<std::size_t>(i)].data.ptr));
        }
    }
    return m_answers - before;
}

void LoadGenerator::ask(Connection &connection, int count)
{
    std::array<std::uint8_t, 64 * requestSize> bytes;
    for (int i = 0; i < count; ++i) {
        std::uint8_t *at = bytes.data() + requestSize * static_cast<std::size_t>(i);
        ++connection.asked;
        std::memcpy(at, request.data(), request.size());
        at[0] = static_cast<std::uint8_t>(connection.asked >> 8);
        at[1] = static_cast<std::uint8_t>(connection.asked & 0xFF);
    }
    const auto size = static_cast<ssize_t>(requestSize) * count;
    if (::send(connection.descriptor, bytes.data(), static_cast<std::size_t>(size), MSG_NOSIGNAL) != size) {
        m_hasFailed = true;
    }
}

/// Every answer is followed by another request, those of one read together.
void LoadGenerator::receive(Connection &connection)
{
    const ssize_t received = ::recv(
        connection.descriptor, connection.bytes.data() + connection.size, connection.bytes.size() - connection.size, 0);
    if (received <= 0) {
        m_hasFailed = true;
        return;
    }
    connection.size += static_cast<std::size_t>(received);
    std::size_t used = 0;
    int count = 0;
    for (; connection.size - used >= answerSize; used += answerSize, ++count) {
        if (!isExpected(connection, connection.bytes.data() + used)) {
            m_hasFailed = true;
            return;
        }
    }
    std::memmove(connection.bytes.data(), connection.bytes.data() + used, connection.size - used);
    connection.size -= used;
    m_answers += static_cast<std::uint64_t>(count);
    if (count > 0) {
        ask(connection, count);
    }
}

bool LoadGenerator::isExpected(Connection &connection, const std::uint8_t *answer)
{
    static constexpr auto expected = expectedAnswer();
    ++connection.answered;
    const bool isTransaction = answer[0] == connection.answered >> 8 && answer[1] == (connection.answered & 0xFF);
    return isTransaction && std::memcmp(answer + 2, expected.data() + 2, expected.size() - 2) == 0;
}

} // namespace gorizont::bench
