#include "core/net/peerwatch.h"

#include "core/net/clientpeer.h"

#include <array>
#include <sys/epoll.h>
#include <unistd.h>

namespace gorizont {

namespace {

constexpr int peersPerTurn = 64; ///< then everybody else in the thread has a turn, such as new readings

bool control(int epoll, int operation, int descriptor, ClientPeer *peer, quint32 events)
{
    epoll_event event{};
    event.events = events;
    event.data.ptr = peer;
    return ::epoll_ctl(epoll, operation, descriptor, &event) == 0;
}

} // namespace

PeerWatch::PeerWatch(QObject *parent)
    : QObject(parent)
    , m_epoll(::epoll_create1(EPOLL_CLOEXEC))
    , m_anyReady(m_epoll, QSocketNotifier::Read, this)
{
    connect(&m_anyReady, &QSocketNotifier::activated, this, &PeerWatch::tellPeers);
}

PeerWatch::~PeerWatch()
{
    m_anyReady.setEnabled(false);
    ::close(m_epoll);
}

bool PeerWatch::add(int descriptor, ClientPeer *peer)
{
    return control(m_epoll, EPOLL_CTL_ADD, descriptor, peer, EPOLLIN);
}

void PeerWatch::remove(int descriptor)
{
    control(m_epoll, EPOLL_CTL_DEL, descriptor, nullptr, 0);
}

void PeerWatch::choose(int descriptor, ClientPeer *peer, bool whenReadable, bool whenWritable)
{
    const quint32 events = (whenReadable ? quint32{EPOLLIN} : 0) | (whenWritable ? quint32{EPOLLOUT} : 0);
    control(m_epoll, EPOLL_CTL_MOD, descriptor, peer, events);
}

/// A peer that ended meanwhile is still there: it is deleted in a later turn of the loop.
void PeerWatch::tellPeers()
{
    std::array<epoll_event, peersPerTurn> events;
    const int count = ::epoll_wait(m_epoll, events.data(), peersPerTurn, 0);
    for (int i = 0; i < count; ++i) {
        const epoll_event &event = events[static_cast<std::size_t>(i)];
        static_cast<ClientPeer *>(event.data.ptr)
            ->onReady(
                (event.events & EPOLLIN) != 0, (event.events & EPOLLOUT) != 0,
                (event.events & (EPOLLERR | EPOLLHUP)) != 0);
    }
}

} // namespace gorizont
