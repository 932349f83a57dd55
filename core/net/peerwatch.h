#pragma once

#include <QObject>
#include <QSocketNotifier>

namespace gorizont {

class ClientPeer;

/// Tells the peers of a desk when their sockets can be read or written. Servers thread.
/// One descriptor of the event loop stands for all sockets: asking the system about each of them at every turn, as the loop
/// does with sockets of its own, costs more than the answers themselves.
class PeerWatch : public QObject
{
    Q_OBJECT

public:
    explicit PeerWatch(QObject *parent = nullptr);
    ~PeerWatch() override;

    /// From now on ClientPeer::onReady() of \a peer is called until remove(). False: the system cannot.
    bool add(int descriptor, ClientPeer *peer);
    /// Before \a descriptor is closed: a process that was just started may hold the same socket for a moment, and then
    /// closing alone ends nothing.
    void remove(int descriptor);
    void choose(int descriptor, ClientPeer *peer, bool whenReadable, bool whenWritable);

private:
    void tellPeers();

    int m_epoll;
    QSocketNotifier m_anyReady;
};

} // namespace gorizont
