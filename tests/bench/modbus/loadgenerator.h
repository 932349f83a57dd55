#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gorizont::bench {

/// Clients of a Modbus TCP server on 127.0.0.1 that ask as fast as they are answered, on plain sockets and epoll in the
/// thread of the caller. Every answer is compared byte by byte with the one expected.
class LoadGenerator
{
public:
    /// \a inFlight: requests that each connection keeps on their way.
    LoadGenerator(int port, int connections, int inFlight);
    ~LoadGenerator();
    LoadGenerator(const LoadGenerator &) = delete;
    LoadGenerator &operator=(const LoadGenerator &) = delete;

    /// Answers that came within \a duration. Can be called again and goes on where it stopped.
    std::uint64_t run(std::chrono::duration<double> duration);
    /// Something was wrong with a connection or an answer; nothing is asked any more.
    bool hasFailed() const { return m_hasFailed; }

private:
    struct Connection
    {
        int descriptor = -1;
        std::uint16_t asked = 0; ///< transaction of the last request
        std::uint16_t answered = 0; ///< transaction of the last answer
        std::array<std::uint8_t, 8192> bytes{};
        std::size_t size = 0;
    };

    void connectOne(int port, Connection &connection);
    void ask(Connection &connection, int count);
    void receive(Connection &connection);
    bool isExpected(Connection &connection, const std::uint8_t *answer);

    int m_poll = -1;
    const int m_inFlight;
    bool m_isStarted = false;
    bool m_hasFailed = false;
    std::uint64_t m_answers = 0;
    std::vector<Connection> m_connections;
};

} // namespace gorizont::bench
