#include "app/server/application.h"

#include "app/server/archive.h"
#include "app/server/feeds.h"
#include "app/server/opcservice.h"
#include "app/server/readingprinter.h"
#include "core/adc24/adc24server.h"
#include "core/history/historywriter.h"
#include "core/modbus/modbusconfig.h"
#include "core/modbus/modbusserver.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QTimer>

namespace gorizont {

namespace {

StatusRules statusRules(const ServerConfig &config)
{
    return {config.timing.readErrorLimit, config.timing.crcErrorLimit, config.hasLegacyStatusBits};
}

Acquisition::Settings acquisitionSettings(const ApplicationSettings &settings)
{
    const ServerConfig &config = settings.config;
    PollingSettings common;
    common.timing = config.timing;
    common.rules = statusRules(config);
    common.gravity = config.gravity;
    common.ringPackets = config.ringPackets;
    common.asksInformation = config.asksInformation;
    return {config.lines, common, settings.ports};
}

HistoryConfig historyConfig(const ApplicationSettings &settings)
{
    HistoryConfig history;
    history.folder = QDir(settings.dataFolder).filePath(QStringLiteral("History"));
    history.saveInterval = settings.config.timing.save;
    history.ringPackets = settings.config.ringPackets;
    history.packetsToSave = settings.config.packetsToSave;
    history.savesFiles = settings.config.savesFiles && settings.ownsDataFolder;
    history.lines = settings.config.lines;
    return history;
}

QString mqttText(const MqttStatus &status)
{
    if (status.isConnected) {
        return Application::tr("MQTT: connected");
    }
    return Application::tr("MQTT: no broker, readings waiting: %1").arg(status.waiting);
}

} // namespace

Application::Application(const ApplicationSettings &settings, QObject *parent)
    : QObject(parent)
    , m_settings(settings)
    , m_registry(settings.config.lines, statusRules(settings.config))
    , m_alarms(m_registry)
    , m_acquisition(acquisitionSettings(settings), m_registry, m_journal)
{
    m_storageThread.setObjectName(QStringLiteral("storage"));
    m_serversThread.setObjectName(QStringLiteral("servers"));
    m_printerThread.setObjectName(QStringLiteral("printer"));
    m_registry.setChains(settings.config.chains);
    connect(&m_alarms, &AlarmWatch::journal, &m_journal, &Journal::append);
    makeHistory();
    m_archive = std::make_unique<Archive>(
        Archive::Site{m_settings.config, m_settings.dataFolder, settings.ownsDataFolder, m_registry, m_journal});
    m_feeds = std::make_unique<Feeds>(Feeds::Site{
        m_settings.config, m_settings.dataFolder, m_settings.ownsDataFolder, m_registry, m_journal, *m_history,
        *m_archive, m_serversThread});
    connect(m_feeds.get(), &Feeds::mqttStatusChanged, this, [this](const MqttStatus &status) {
        m_mqttText = mqttText(status);
        tellServerStatus();
    });
    if (settings.config.servesModbus) {
        makeModbus();
    }
    makeAdc24();
    if (settings.config.servesOpc) {
        makeOpc();
    }
    if (settings.printsReadings) {
        makePrinter();
    }
}

Application::~Application()
{
    shutdown();
}

ArchiveReader &Application::archive()
{
    return m_archive->reader();
}

std::function<void(const DeviceRecords &)> Application::recordSink()
{
    return m_archive->recordSink();
}

void Application::makeHistory()
{
    m_history = std::make_unique<HistoryWriter>(historyConfig(m_settings));
    HistoryWriter *history = m_history.get();
    // Direct: the slots only leave the values in an inbox of bounded size.
    connect(
        &m_registry, &SensorRegistry::readingsChanged, history, &HistoryWriter::updateReadings, Qt::DirectConnection);
    connect(&m_registry, &SensorRegistry::lineChanged, history, &HistoryWriter::updateLine, Qt::DirectConnection);
    connect(&m_registry, &SensorRegistry::blockAdded, history, &HistoryWriter::appendBlock, Qt::DirectConnection);
    connect(&m_journal, &Journal::added, history, &HistoryWriter::appendJournal, Qt::DirectConnection);
    connect(history, &HistoryWriter::packetsSaved, &m_registry, &SensorRegistry::setPacketsSaved);
    connect(history, &HistoryWriter::dataLineWritten, this, &Application::measurementWritten);
    connect(history, &HistoryWriter::journal, &m_journal, &Journal::append);
    history->updateReadings(m_registry.readings());
    for (const LineStatus &status : m_registry.lineStatuses()) {
        history->updateLine(status);
    }
    history->moveToThread(&m_storageThread);
    connect(&m_storageThread, &QThread::started, history, &HistoryWriter::start);
    connect(&m_storageThread, &QThread::finished, history, &HistoryWriter::stop, Qt::DirectConnection);
}

void Application::makeModbus()
{
    m_modbus = std::make_unique<ModbusServer>(modbusConfig(m_settings.config));
    ModbusServer *modbus = m_modbus.get();
    connect(&m_registry, &SensorRegistry::readingsChanged, modbus, &ModbusServer::updateReadings, Qt::QueuedConnection);
    connect(&m_registry, &SensorRegistry::lineChanged, modbus, &ModbusServer::updateLine, Qt::QueuedConnection);
    connectDesk(modbus->desk());
    connect(modbus, &ModbusServer::stateChanged, this, [this](QModbusDevice::State state) {
        m_modbusText = modbusText(state);
        tellServerStatus();
    });
    modbus->updateReadings(m_registry.readings());
    for (const LineStatus &status : m_registry.lineStatuses()) {
        modbus->updateLine(status);
    }
    modbus->moveToThread(&m_serversThread);
    connect(&m_serversThread, &QThread::started, modbus, &ModbusServer::connectDevice);
    connect(&m_serversThread, &QThread::finished, modbus, &ModbusServer::disconnectDevice, Qt::DirectConnection);
}

void Application::makeAdc24()
{
    const auto config = adc24Config(m_settings.config);
    if (!config) {
        return;
    }
    m_adc24 = std::make_unique<Adc24Server>(*config);
    Adc24Server *adc24 = m_adc24.get();
    connect(&m_registry, &SensorRegistry::readingsChanged, adc24, &Adc24Server::updateReadings, Qt::QueuedConnection);
    connect(&m_registry, &SensorRegistry::blockAdded, adc24, &Adc24Server::appendBlock, Qt::QueuedConnection);
    connectDesk(adc24->desk());
    adc24->updateReadings(m_registry.readings());
    adc24->moveToThread(&m_serversThread);
    connect(&m_serversThread, &QThread::started, adc24, &Adc24Server::start);
    connect(&m_serversThread, &QThread::finished, adc24, &Adc24Server::stop, Qt::DirectConnection);
}

void Application::makeOpc()
{
    m_opc = std::make_unique<OpcService>(OpcService::Site{
        m_settings.config, m_settings.dataFolder, m_settings.ownsDataFolder, m_registry, m_journal, m_serversThread});
    connect(m_opc.get(), &OpcService::clientsChanged, this, [this](const QList<ClientInfo> &all) {
        Q_EMIT clientsChanged(OpcFeed::service(), all);
        m_feeds->setClients(OpcFeed::service(), all.size());
    });
    connect(m_opc.get(), &OpcService::firstRunDone, this, &Application::opcFirstRunDone);
    m_feeds->setClients(OpcFeed::service(), 0);
}

/// Before \a desk moves to its thread.
void Application::connectDesk(ClientDesk &desk)
{
    connect(&desk, &ClientDesk::journal, &m_journal, &Journal::append);
    connect(&desk, &ClientDesk::clientsChanged, this, [this, service = desk.service()](const QList<ClientInfo> &all) {
        Q_EMIT clientsChanged(service, all);
        m_feeds->setClients(service, all.size());
    });
    m_feeds->setClients(desk.service(), 0);
    m_desks.push_back(&desk);
}

void Application::dismissClient(const QString &service, const QHostAddress &address, quint16 port)
{
    if (m_opc && service == OpcFeed::service()) {
        m_opc->dismiss(address, port);
    }
    for (ClientDesk *desk : m_desks) {
        if (desk->service() == service) {
            QMetaObject::invokeMethod(
                desk, [desk, address, port] { desk->dismiss(address, port); }, Qt::QueuedConnection);
        }
    }
}

void Application::makePrinter()
{
    m_printer = std::make_unique<ReadingPrinter>(m_registry);
    ReadingPrinter *printer = m_printer.get();
    printer->moveToThread(&m_printerThread);
    connect(&m_registry, &SensorRegistry::readingsChanged, this, [printer](const Readings &batch) {
        printer->offer(batch);
    });
}

void Application::start()
{
    m_isRunning = true;
    m_storageThread.start();
    m_archive->start();
    m_journal.add(JournalKind::On, tr("Gorizont Server %1 started").arg(QStringLiteral(GORIZONT_VERSION)));
    tellComplaints();
    m_serversThread.start();
    m_feeds->start();
    m_printerThread.start();
    // TmStart: files and servers get ready before the first reading.
    QTimer::singleShot(m_settings.config.timing.start, this, [this] {
        if (m_isRunning) {
            m_acquisition.start();
        }
    });
}

void Application::tellComplaints()
{
    for (const Complaint &complaint : m_settings.complaints) {
        m_journal.add(JournalKind::Error, complaint.text());
    }
    if (m_settings.config.savesFiles && !m_settings.ownsDataFolder) {
        m_journal.add(
            JournalKind::Error,
            tr("Another copy of the program writes into %1: this copy does not save. Give it a folder of its own.")
                .arg(QDir::toNativeSeparators(m_settings.dataFolder)));
    }
    if (m_settings.config.mqtt.isOn() && !m_settings.ownsDataFolder) {
        m_journal.add(
            JournalKind::Error,
            tr("Another copy of the program sends from %1 to the MQTT broker: this copy does not send.")
                .arg(QDir::toNativeSeparators(m_settings.dataFolder)));
    }
}

QString Application::modbusText(QModbusDevice::State state) const
{
    switch (state) {
    case QModbusDevice::ConnectedState: return tr("Modbus TCP: port %1").arg(m_settings.config.modbusPort);
    case QModbusDevice::ConnectingState:
        return tr("Modbus TCP: port %1 cannot be used").arg(m_settings.config.modbusPort);
    case QModbusDevice::UnconnectedState:
    case QModbusDevice::ClosingState: break;
    }
    return tr("Modbus TCP: off");
}

void Application::tellServerStatus()
{
    QStringList texts{m_modbusText, m_mqttText};
    texts.removeAll(QString());
    Q_EMIT serverStatusChanged(texts.join(QStringLiteral(" · ")));
}

/// What ended threads have queued for the journal: no event loop delivers it any more.
void Application::hearLastWords()
{
    QCoreApplication::sendPostedEvents(&m_journal, QEvent::MetaCall);
}

bool Application::shutdown()
{
    if (!m_isRunning) {
        return true;
    }
    m_isRunning = false;
    const QDeadlineTimer deadline(m_settings.config.timing.exitLimit);
    m_serversThread.quit();
    m_printerThread.quit();
    m_feeds->stop();
    // A line that hangs in the system must leave time for the files.
    bool haveAllEnded = m_acquisition.stop(m_settings.config.timing.exitLimit * 3 / 4);
    // The files end last: what the others say at their end has to get there, and a server that hangs must not keep them.
    const QDeadlineTimer servers(deadline.remainingTime() / 2);
    haveAllEnded = m_serversThread.wait(servers) && haveAllEnded;
    haveAllEnded = m_feeds->wait(servers) && haveAllEnded;
    hearLastWords();
    m_journal.add(JournalKind::Off, tr("Gorizont Server ended"));
    m_archive->stop();
    m_storageThread.quit();
    haveAllEnded = m_storageThread.wait(deadline) && haveAllEnded;
    haveAllEnded = m_archive->wait(deadline) && haveAllEnded;
    return m_printerThread.wait(deadline) && haveAllEnded;
}

} // namespace gorizont
