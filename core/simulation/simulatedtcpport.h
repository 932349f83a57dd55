#pragma once

#include "core/simulation/simulatedbus.h"

#include <QHash>
#include <QTcpServer>
#include <QTimer>

#include <memory>

class QTcpSocket;

namespace gorizont {

/// A simulated port of `Device=tcp://…`: devices that speak Modbus TCP, behind a listening socket of this computer. Several
/// clients may be connected at once; each whole request reaches every device. Lives in one thread with an event loop.
class SimulatedTcpPort : public QObject
{
    Q_OBJECT

public:
    SimulatedTcpPort(const LineConfig &config, const SimulatedBus::Options &options);
    ~SimulatedTcpPort() override;

    /// Whether \a device is `tcp://` on this computer: only there a simulation may listen.
    static bool isOwn(const QString &device);

    /// False: the socket cannot be had, errorString() says why. A port of 0 is one that is free.
    bool plug();
    /// Nobody listens any more, and whoever is connected loses the connection.
    void unplug();

    QString errorString() const { return m_server.errorString(); }
    quint16 port() const { return m_server.serverPort(); }
    const SimulatedBus &bus() const { return m_bus; }

private:
    struct Answer
    {
        QTcpSocket *client;
        SimulatedBus::Piece piece;
    };

    void onConnection();
    void onRequest(QTcpSocket *client);
    void onDisconnected(QTcpSocket *client);
    void dropClients();
    void sendDue();
    SimulatedBus::Time now() const;

    SimulatedBus m_bus;
    quint16 m_port; ///< of the next plug()
    std::chrono::steady_clock::time_point m_started = std::chrono::steady_clock::now();
    QTcpServer m_server{this};
    QHash<QTcpSocket *, QByteArray> m_heard; ///< by client: what is not a whole request yet
    QList<Answer> m_arriving;
    QTimer m_timer{this};
};

} // namespace gorizont
