#pragma once

#include "app/server/acquisition.h"
#include "core/alarms/alarmwatch.h"
#include "core/config/serverconfig.h"
#include "core/net/clientinfo.h"
#include "core/values/devicerecord.h"

#include <QModbusDevice>
#include <QObject>
#include <QThread>

#include <functional>
#include <memory>
#include <vector>

namespace gorizont {

class Adc24Server;
class Archive;
class ArchiveReader;
class ClientDesk;
class Feeds;
class HistoryWriter;
class ModbusServer;
class OpcService;
class ReadingPrinter;

/// What the command line adds to the configuration.
struct ApplicationSettings
{
    ServerConfig config;
    QList<Complaint> complaints;
    QString dataFolder; ///< where History goes
    bool ownsDataFolder = true; ///< false: another copy writes there, this one only reads, shows and serves
    PortNaming ports;
    bool printsReadings = false;
};

/// The composition root: makes the registry and all that produces or consumes readings, each in its thread, and
/// connects them. Knows nothing of windows. Main thread.
class Application : public QObject
{
    Q_OBJECT

public:
    explicit Application(const ApplicationSettings &settings, QObject *parent = nullptr);
    ~Application() override;

    SensorRegistry &registry() { return m_registry; }
    Journal &journal() { return m_journal; }
    AlarmWatch &alarms() { return m_alarms; }
    /// What the archive answers, also while another copy of the program writes it.
    ArchiveReader &archive();
    /// Where records go that were downloaded from devices; empty: no archive is written here. Not to be called after the end.
    std::function<void(const DeviceRecords &)> recordSink();
    /// The worker of section [Port\a port]; null when the port is off.
    LineWorker *worker(int port) const { return m_acquisition.worker(port); }
    /// Opens ports that wait and asks sensors that are parked, at once.
    void retryLines() { m_acquisition.retry(); }

    /// Cuts off one connection of \a service; nothing happens when it has gone meanwhile.
    void dismissClient(const QString &service, const QHostAddress &address, quint16 port);

    void start();

    /// Stop timers → interrupt lines → quit → flush storage → wait, all within PExit. False: a thread did not end in time
    /// and the process has to end hard. The second call does nothing.
    bool shutdown();

Q_SIGNALS:
    /// A record of `_data` for the measurements tab.
    void measurementWritten(const QString &line);
    /// What the Modbus server and the link to the broker do, for the status bar.
    void serverStatusChanged(const QString &text);
    /// All clients of \a service: once a second while there are any, and once after the last one left.
    void clientsChanged(const QString &service, const QList<gorizont::ClientInfo> &clients);
    /// The first run with OPC DA, or with another list of tags, has done what it has to; \a message says what.
    void opcFirstRunDone(const QString &message);

private:
    void makeHistory();
    void makeModbus();
    void makeAdc24();
    void makeOpc();
    void connectDesk(ClientDesk &desk);
    void makePrinter();
    void tellComplaints();
    QString modbusText(QModbusDevice::State state) const;
    void tellServerStatus();
    void hearLastWords();

    ApplicationSettings m_settings;
    SensorRegistry m_registry;
    Journal m_journal;
    AlarmWatch m_alarms;
    Acquisition m_acquisition;
    QThread m_storageThread;
    QThread m_serversThread;
    QThread m_printerThread;
    std::unique_ptr<HistoryWriter> m_history;
    std::unique_ptr<Archive> m_archive;
    std::unique_ptr<Feeds> m_feeds; ///< MQTT and metrics
    std::unique_ptr<ModbusServer> m_modbus; ///< empty: CanModbus=0
    std::unique_ptr<Adc24Server> m_adc24; ///< empty: CanADC24=0, or no accelerometer
    std::unique_ptr<OpcService> m_opc; ///< empty: CanOPCDA=0
    std::vector<ClientDesk *> m_desks; ///< of Modbus and ADC24, which own them
    std::unique_ptr<ReadingPrinter> m_printer; ///< empty: without --print-readings
    QString m_modbusText;
    QString m_mqttText;
    bool m_isRunning = false;
};

} // namespace gorizont
