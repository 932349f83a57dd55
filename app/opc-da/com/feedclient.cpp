#include "app/opc-da/com/feedclient.h"

#include <thread>

namespace opcda {

namespace {

constexpr DWORD Silence = 6000; ///< ms, two pings of the main program and some more
constexpr auto Pause = std::chrono::seconds(2);
constexpr std::size_t LongestLine = 4 << 20;

/// Closed at the end of its scope.
class Conversation
{
public:
    explicit Conversation(unsigned short port)
        : m_socket(socket(AF_INET, SOCK_STREAM, IPPROTO_TCP))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const auto *generic = reinterpret_cast<const sockaddr *>(&address);
        m_isOpen = m_socket != INVALID_SOCKET && connect(m_socket, generic, sizeof(address)) == 0;
        setsockopt(m_socket, SOL_SOCKET, SO_RCVTIMEO, reinterpret_cast<const char *>(&Silence), sizeof(Silence));
    }
    ~Conversation()
    {
        if (m_socket != INVALID_SOCKET)
            closesocket(m_socket);
    }
    Conversation(const Conversation &) = delete;
    Conversation &operator=(const Conversation &) = delete;

    bool isOpen() const { return m_isOpen; }
    SOCKET get() const { return m_socket; }

private:
    SOCKET m_socket;
    bool m_isOpen = false;
};

} // namespace

FeedClient::FeedClient(Gate &gate, Settings settings, HANDLE ready, HANDLE ended)
    : m_gate(gate)
    , m_settings(std::move(settings))
    , m_ready(ready)
    , m_ended(ended)
{
}

void FeedClient::run()
{
    WSADATA data;
    WSAStartup(MAKEWORD(2, 2), &data);
    for (;;) {
        bool isOver = false;
        {
            const Conversation connection(m_settings.port);
            isOver = connection.isOpen() && converse(connection.get());
        }
        {
            const std::scoped_lock lock(m_gate.mutex());
            m_gate.book().lose(unixMilliseconds());
        }
        if (isOver)
            break;
        std::this_thread::sleep_for(Pause);
    }
    SetEvent(m_ended);
}

bool FeedClient::converse(SOCKET socket)
{
    const std::string greeting = feedGreeting(GORIZONT_VERSION, GetCurrentProcessId(), m_settings.hash);
    if (send(socket, greeting.data(), static_cast<int>(greeting.size()), 0) != static_cast<int>(greeting.size()))
        return false;
    m_hasList = false;
    std::string pending;
    std::vector<char> piece(65536);
    while (pending.size() < LongestLine) {
        const int count = recv(socket, piece.data(), static_cast<int>(piece.size()), 0);
        if (count <= 0)
            return false;
        pending.append(piece.data(), static_cast<std::size_t>(count));
        std::size_t begin = 0;
        for (std::size_t end = 0; (end = pending.find('\n', begin)) != std::string::npos; begin = end + 1) {
            const TagBook::Answer answer = take(std::string_view(pending).substr(begin, end - begin));
            if (answer == TagBook::Answer::HangUp || answer == TagBook::Answer::End)
                return answer == TagBook::Answer::End;
        }
        pending.erase(0, begin);
    }
    return false;
}

TagBook::Answer FeedClient::take(std::string_view line)
{
    const FeedLine parsed = parseFeedLine(line);
    TagBook::Answer answer = TagBook::Answer::None;
    {
        const std::scoped_lock lock(m_gate.mutex());
        answer = m_gate.book().accept(parsed, unixMilliseconds());
    }
    if (m_hasList)
        SetEvent(m_ready);
    m_hasList = m_hasList || answer == TagBook::Answer::Ready;
    return answer;
}

} // namespace opcda
