#pragma once

#include "core/simulation/simulatedbus.h"

#include <QObject>
#include <QTimer>

#include <memory>

class QSocketNotifier;

namespace gorizont {

/// One simulated port: a pty linked as `DIR/COMn` whose other end is a SimulatedBus. Lives in one thread with
/// an event loop. Real byte timing of the answers; what nobody reads is lost, as on a wire.
class PtyPort : public QObject
{
    Q_OBJECT

public:
    PtyPort(const LineConfig &config, const SimulatedBus::Options &options, const QString &directory);
    ~PtyPort() override;

    QString linkPath() const { return m_linkPath; }
    std::size_t sensorCount() const { return m_bus.devices().size(); }

    /// False with errno set when the system gives no pty or the link cannot be made.
    bool plug();
    /// The port vanishes: whoever has it open loses it.
    void unplug();

private:
    void onRequest();
    void followHost();
    void sendDue();
    void planNext();
    SimulatedBus::Time now() const;

    SimulatedBus m_bus;
    QString m_linkPath;
    std::chrono::steady_clock::time_point m_started = std::chrono::steady_clock::now();
    int m_master = -1;
    int m_slave = -1; ///< kept open, so that a client that closes the port does not hang the pty up
    std::unique_ptr<QSocketNotifier> m_notifier;
    QTimer m_timer{this};
    QList<SimulatedBus::Piece> m_arriving;
};

} // namespace gorizont
