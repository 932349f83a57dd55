#include "tests/bench/modbus/payload.h"
#include "tests/bench/modbus/servers.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <modbus.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace gorizont::bench {

namespace {

constexpr int backlog = 512;

int portOf(int listener)
{
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(listener, reinterpret_cast<sockaddr *>(&address), &size);
    return ntohs(address.sin_port);
}

int listenAnywhere()
{
    const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const bool isBound = ::bind(listener, reinterpret_cast<const sockaddr *>(&address), sizeof address) == 0;
    return isBound && ::listen(listener, backlog) == 0 ? listener : -1;
}

/// One request of one client of libmodbus; false: it has gone.
bool serveOnce(modbus_t *context, modbus_mapping_t *registers, int client)
{
    std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
    modbus_set_socket(context, client);
    const int size = modbus_receive(context, request.data());
    if (size > 0) {
        modbus_reply(context, request.data(), size, registers);
    }
    return size >= 0;
}

struct BareClient
{
    std::array<std::uint8_t, 4096> bytes{};
    std::size_t size = 0;
};

/// Answers all whole requests in the buffer of a client with one write.
void answerBare(int descriptor, BareClient &client)
{
    static constexpr auto registers = payload();
    std::array<std::uint8_t, 4096 / requestSize * answerSize> answers;
    std::size_t at = 0;
    std::size_t used = 0;
    while (client.size - used >= requestSize) {
        std::uint8_t *answer = answers.data() + at;
        std::memcpy(answer, client.bytes.data() + used, 8);
        answer[4] = 0;
        answer[5] = answerSize - 6;
        answer[8] = payloadSize;
        std::memcpy(answer + 9, registers.data(), registers.size());
        at += answerSize;
        used += requestSize;
    }
    std::memmove(client.bytes.data(), client.bytes.data() + used, client.size - used);
    client.size -= used;
    if (at > 0 && ::send(descriptor, answers.data(), at, MSG_NOSIGNAL) < 0) {
        ::shutdown(descriptor, SHUT_RDWR);
    }
}

void acceptBare(int poll, int listener, std::vector<BareClient> &clients)
{
    const int descriptor = ::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK);
    if (descriptor < 0) {
        return;
    }
    const int noDelay = 1;
    ::setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &noDelay, sizeof noDelay);
    clients.resize(std::max(clients.size(), static_cast<std::size_t>(descriptor) + 1));
    clients[static_cast<std::size_t>(descriptor)] = {};
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.fd = descriptor;
    ::epoll_ctl(poll, EPOLL_CTL_ADD, descriptor, &event);
}

} // namespace

int serveLibmodbus(int, char **)
{
    modbus_t *context = modbus_new_tcp("127.0.0.1", 0);
    modbus_mapping_t *registers = modbus_mapping_new(0, 0, 0, registerCount);
    for (int i = 0; i < registerCount; ++i) {
        registers->tab_input_registers[i] = payloadRegister(i);
    }
    const int listener = listenAnywhere(); // modbus_tcp_listen() takes port 0 for the default one
    fd_set all;
    FD_ZERO(&all);
    FD_SET(listener, &all);
    int last = listener;
    tellPort(portOf(listener));
    for (;;) {
        fd_set ready = all;
        if (::select(last + 1, &ready, nullptr, nullptr, nullptr) < 0) {
            return 1;
        }
        for (int descriptor = 0; descriptor <= last; ++descriptor) {
            if (!FD_ISSET(descriptor, &ready)) {
                continue;
            }
            if (descriptor == listener) {
                int accepting = listener;
                const int client = modbus_tcp_accept(context, &accepting);
                if (client >= 0 && client < FD_SETSIZE) {
                    FD_SET(client, &all);
                    last = std::max(last, client);
                }
            } else if (!serveOnce(context, registers, descriptor)) {
                ::close(descriptor);
                FD_CLR(descriptor, &all);
            }
        }
    }
}

int serveBare(int, char **)
{
    const int listener = listenAnywhere();
    const int poll = ::epoll_create1(0);
    epoll_event arrival{};
    arrival.events = EPOLLIN;
    arrival.data.fd = listener;
    ::epoll_ctl(poll, EPOLL_CTL_ADD, listener, &arrival);
    std::vector<BareClient> clients;
    tellPort(portOf(listener));
    for (;;) {
        std::array<epoll_event, 64> events{};
        const int count = ::epoll_wait(poll, events.data(), static_cast<int>(events.size()), -1);
        for (int i = 0; i < count; ++i) {
            const int descriptor = events[static_cast<std::size_t>(i)].data.fd;
            if (descriptor == listener) {
                acceptBare(poll, listener, clients);
                continue;
            }
            BareClient &client = clients[static_cast<std::size_t>(descriptor)];
            const ssize_t size =
                ::recv(descriptor, client.bytes.data() + client.size, client.bytes.size() - client.size, 0);
            if (size <= 0) {
                ::close(descriptor);
                continue;
            }
            client.size += static_cast<std::size_t>(size);
            answerBare(descriptor, client);
        }
    }
}

} // namespace gorizont::bench
