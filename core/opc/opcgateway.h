#pragma once

#include "core/net/clientinfo.h"
#include "core/opc/opcimage.h"
#include "core/opc/opclines.h"

#include <QObject>
#include <QTcpSocket>
#include <QTimer>

namespace gorizont {

/// What every gateway is sent at first, made once.
struct OpcOpening
{
    QByteArray hello;
    QList<QByteArray> tags;
};

/// The program's end of one connection of the feed. Servers thread.
/// A gateway that does not read costs a flag a tag: what waits for it is the numbers of the tags, and the values are those of the
/// moment when there is room for them.
class OpcGateway : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 unsentLimit = 65536; ///< bytes that wait in this process, but for one line

    struct Pace
    {
        std::chrono::milliseconds ping{2000}; ///< of silence, then a ping
        std::chrono::milliseconds stall{60000}; ///< a gateway that takes nothing for so long is dropped
    };

    enum class End : quint8 { Left, Malformed, Stalled };
    Q_ENUM(End)

    /// Takes over \a socket. Image and opening outlive the gateway.
    OpcGateway(
        QTcpSocket *socket, const OpcImage &image, const OpcOpening &opening, const Pace &pace,
        QObject *parent = nullptr);

    /// These tags changed; they are sent by the next passChanges().
    void note(const std::vector<int> &changed);
    void passChanges();
    /// The program ends. Nothing more is sent; what the system takes at once still arrives.
    void sayGoodbye();
    /// Ends the connection without ended().
    void leave();

    const QHostAddress &address() const { return m_info.address; }
    quint16 port() const { return m_info.port; } ///< of the client
    ClientInfo info() const { return m_info; }

Q_SIGNALS:
    /// The first thing a gateway says.
    void greeted(const gorizont::opclines::Greeting &greeting);
    /// Once, from inside a slot of the gateway: delete it later.
    void ended(gorizont::OpcGateway::End end);

private:
    void receive();
    void takeLine(QByteArrayView line);
    void pump();
    bool hasRoom() const { return m_socket->bytesToWrite() < unsentLimit; }
    QByteArray nextLine();
    QByteArray nextValues();
    void send(const QByteArray &line);
    void onTaken();
    void onSilence();
    void end(End how);

    QTcpSocket *m_socket; ///< a child
    const OpcImage &m_image;
    const OpcOpening &m_opening;
    const Pace m_pace;
    QTimer m_silence;
    SteadyTime m_lastTaken = SteadyTime::clock::now();
    qsizetype m_openingLine = -1; ///< of the opening, the next one: −1 hello, then the tags, then ready
    std::vector<char> m_isWaiting; ///< a flag a tag: it stands in the queue
    std::vector<int> m_queue; ///< tags whose values are to be sent, each once
    std::size_t m_queueStart = 0;
    QByteArray m_rest; ///< the start of a line of the client
    bool m_hasGreeted = false;
    bool m_hasEnded = false;
    ClientInfo m_info;
};

} // namespace gorizont
