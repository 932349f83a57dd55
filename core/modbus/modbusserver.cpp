#include "core/modbus/modbusserver.h"

#include "core/modbus/modbussentences.h"
#include "core/protocol/bytes.h"

#include <QLoggingCategory>
#include <QMetaMethod>

#include <algorithm>

namespace gorizont {

namespace {

Q_LOGGING_CATEGORY(logServer, "gorizont.server", QtInfoMsg)

using namespace std::chrono_literals;

constexpr auto roundInterval = 1000ms;

/// Half the idle limit, at most a second: nobody is cut off later than one and a half times the limit.
std::chrono::milliseconds roundFor(std::chrono::milliseconds idle)
{
    return idle.count() > 0 ? std::clamp<std::chrono::milliseconds>(idle / 2, 10ms, roundInterval) : roundInterval;
}

} // namespace

ModbusServer::ModbusServer(const ModbusConfig &config, QObject *parent)
    : QModbusServer(parent)
    , m_config(config)
    , m_allowed(config.allow)
    , m_images(config)
    , m_listener(config.retry, config.acceptPause, this)
    , m_round(this)
{
    setServerAddress(UnitImages::tiltUnit);
    setConnectionParameter(NetworkPortParameter, config.port);
    setConnectionParameter(NetworkAddressParameter, config.bind);
    m_round.setInterval(roundFor(config.idle));
    connect(&m_round, &QTimer::timeout, this, &ModbusServer::lookAround);
    connect(&m_listener, &TcpListener::listening, this, &ModbusServer::onListening);
    connect(&m_listener, &TcpListener::listenFailed, this, &ModbusServer::onListenFailed);
    connect(&m_listener, &TcpListener::connected, this, &ModbusServer::onConnected);
    connect(&m_listener, &TcpListener::acceptFailed, this, [this](const QString &reason) {
        tell(JournalKind::Error, modbussentence::cannotAccept(reason));
    });
    connect(&m_listener, &TcpListener::acceptsAgain, this, [this] {
        tell(JournalKind::Info, modbussentence::acceptsAgain());
    });
}

ModbusServer::~ModbusServer()
{
    qDeleteAll(m_peers); // before the images they read
}

void ModbusServer::updateReadings(const QList<Reading> &batch)
{
    for (const Reading &reading : batch) {
        m_images.update(reading);
    }
}

void ModbusServer::updateLine(const LineStatus &status)
{
    m_images.updateLine(status);
}

bool ModbusServer::open()
{
    const QString bind = connectionParameter(NetworkAddressParameter).toString();
    if (!bind.isEmpty() && QHostAddress(bind).isNull()) {
        // Listening everywhere instead would serve those whom somebody meant to keep out.
        tell(JournalKind::Error, modbussentence::badBindAddress(bind));
        setError(modbussentence::badBindAddress(bind), ConfigurationError);
        return false;
    }
    for (const QString &entry : m_allowed.unreadable()) {
        tell(JournalKind::Error, modbussentence::badAllowEntry(entry));
    }
    if (!m_images.unreachable().isEmpty()) {
        tell(JournalKind::Error, m_images.unreachable().sentence());
    }
    const auto port = static_cast<quint16>(connectionParameter(NetworkPortParameter).toInt());
    m_listener.start(bind.isEmpty() ? QHostAddress(QHostAddress::Any) : QHostAddress(bind), port);
    return true;
}

void ModbusServer::onListening()
{
    m_round.start();
    setState(ConnectedState);
    tell(JournalKind::On, modbussentence::listening(serverPort()));
}

void ModbusServer::onListenFailed(QAbstractSocket::SocketError error, const QString &reason)
{
    const int port = connectionParameter(NetworkPortParameter).toInt();
    const auto retry = std::chrono::ceil<std::chrono::seconds>(m_config.retry);
    const QString text = modbussentence::cannotListen(port, error, reason, retry);
    tell(JournalKind::Error, text);
    setError(text, ConnectionError);
}

void ModbusServer::close()
{
    const bool wasListening = m_listener.isListening();
    m_listener.stop();
    m_round.stop();
    while (!m_peers.empty()) {
        remove(m_peers.back());
    }
    publishClients();
    setState(UnconnectedState);
    if (wasListening) {
        tell(JournalKind::Off, modbussentence::stopped());
    }
}

void ModbusServer::onConnected(QTcpSocket *socket)
{
    const QHostAddress address = plainAddress(socket->peerAddress());
    if (m_allowed.admits(address)) {
        admit(socket);
        return;
    }
    socket->abort();
    socket->deleteLater();
    tellTrouble(ClientTrouble::Refused, address);
}

void ModbusServer::admit(QTcpSocket *socket)
{
    makeRoom();
    auto *peer = new ModbusPeer(socket, m_images, m_config.stall, this);
    m_peers.push_back(peer);
    connect(peer, &ModbusPeer::ended, this, [this, peer](ModbusPeer::End how) { onEnded(peer, how); });
    qCDebug(logServer) << "modbus client" << peer->address() << "came," << m_peers.size() << "connected";
    if (m_diary.arrives(peer->address(), SteadyTime::clock::now())) {
        tell(JournalKind::Info, modbussentence::came(peer->address()));
    }
}

void ModbusServer::makeRoom()
{
    while (m_peers.size() >= static_cast<std::size_t>(std::max(m_config.clients, 1))) {
        const auto longestIdle =
            std::min_element(m_peers.begin(), m_peers.end(), [](const ModbusPeer *a, const ModbusPeer *b) {
                return a->lastActive() < b->lastActive();
            });
        dismiss(*longestIdle, ClientTrouble::GaveWay);
    }
}

void ModbusServer::onEnded(ModbusPeer *peer, ModbusPeer::End how)
{
    switch (how) {
    case ModbusPeer::End::Left: remove(peer); break;
    case ModbusPeer::End::Malformed: dismiss(peer, ClientTrouble::Malformed); break;
    case ModbusPeer::End::Stalled: dismiss(peer, ClientTrouble::Stalled); break;
    }
}

void ModbusServer::dismiss(ModbusPeer *peer, ClientTrouble reason)
{
    const QHostAddress address = peer->address();
    remove(peer);
    tellTrouble(reason, address);
}

void ModbusServer::remove(ModbusPeer *peer)
{
    qCDebug(logServer) << "modbus client" << peer->address() << "goes after" << peer->info().requests << "requests";
    std::erase(m_peers, peer);
    m_diary.leaves(peer->address(), SteadyTime::clock::now());
    peer->leave();
    peer->deleteLater();
}

void ModbusServer::lookAround()
{
    const SteadyTime now = SteadyTime::clock::now();
    dismissIdle(now);
    for (const ClientDiary::Departure &departure : m_diary.departures(now)) {
        const auto ago = std::chrono::duration_cast<std::chrono::microseconds>(now - departure.left);
        tell(JournalKind::Info, modbussentence::gone(departure.address, utcNow() - ago));
    }
    publishClients();
}

void ModbusServer::dismissIdle(SteadyTime now)
{
    if (m_config.idle.count() <= 0) {
        return;
    }
    const std::vector<ModbusPeer *> peers = m_peers;
    for (ModbusPeer *peer : peers) {
        if (now - peer->lastActive() >= m_config.idle) {
            dismiss(peer, ClientTrouble::Idle);
        }
    }
}

QList<ModbusClientInfo> ModbusServer::clients() const
{
    QList<ModbusClientInfo> all;
    all.reserve(static_cast<qsizetype>(m_peers.size()));
    for (const ModbusPeer *peer : m_peers) {
        all.append(peer->info());
    }
    return all;
}

void ModbusServer::publishClients()
{
    static const QMetaMethod changed = QMetaMethod::fromSignal(&ModbusServer::clientsChanged);
    if (isSignalConnected(changed) && (m_hasPublished || !m_peers.empty())) {
        m_hasPublished = !m_peers.empty();
        Q_EMIT clientsChanged(clients());
    }
}

void ModbusServer::tell(JournalKind kind, const QString &text)
{
    JournalEntry entry;
    entry.kind = kind;
    entry.time = utcNow();
    entry.text = text;
    Q_EMIT journal(entry);
}

void ModbusServer::tellTrouble(ClientTrouble trouble, const QHostAddress &address)
{
    if (m_diary.isNews(trouble, address, SteadyTime::clock::now())) {
        const bool isFault = trouble == ClientTrouble::Malformed || trouble == ClientTrouble::Stalled;
        tell(isFault ? JournalKind::Error : JournalKind::Info, modbussentence::trouble(trouble, address));
    }
}

bool ModbusServer::setMap(const QModbusDataUnitMap &)
{
    return false;
}

bool ModbusServer::writeData(const QModbusDataUnit &)
{
    return false;
}

bool ModbusServer::readData(QModbusDataUnit *unit) const
{
    const RegisterBlock *block = m_images.inputRegisters(serverAddress());
    if (unit == nullptr || block == nullptr || unit->registerType() != QModbusDataUnit::InputRegisters) {
        return false;
    }
    const auto bytes = block->registers(unit->startAddress(), static_cast<int>(unit->valueCount()));
    if (!bytes) {
        return false;
    }
    for (qsizetype i = 0; i < bytes->size() / 2; ++i) {
        unit->setValue(i, readBig<quint16>(*bytes, 2 * i).value_or(0));
    }
    return true;
}

} // namespace gorizont
