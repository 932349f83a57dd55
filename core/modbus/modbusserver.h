#pragma once

#include "core/modbus/allowlist.h"
#include "core/modbus/clientdiary.h"
#include "core/modbus/modbuspeer.h"
#include "core/modbus/tcplistener.h"
#include "core/values/journalentry.h"

#include <QModbusServer>

#include <vector>

namespace gorizont {

/// Serves units 3 and 6 over Modbus TCP (manual 000, section 10; spec/gorizont.md, section 6). Servers thread.
///
/// QModbusServer is Qt's base for a transport of one's own; QModbusTcpServer is not used: it answers one unit only,
/// hangs for good on a request of seven bytes, buffers without limit and leaks. The requests do not pass through the
/// base's register map either: answers are copied from images that are always ready, which is also much faster.
///
/// connectDevice() and disconnectDevice() are called in the thread of the server. While the port cannot be had the state
/// is ConnectingState, and the server goes on trying.
class ModbusServer : public QModbusServer
{
    Q_OBJECT

public:
    explicit ModbusServer(const ModbusConfig &config, QObject *parent = nullptr);
    ~ModbusServer() override;

    quint16 serverPort() const { return m_listener.port(); } ///< 0: not listening
    /// Who is connected now, in the order they came. Only in the thread of the server.
    QList<gorizont::ModbusClientInfo> clients() const;

    /// The images are the only registers there are: this base-class door only reads. data() shows the input registers of
    /// unit serverAddress(), at first 3.
    bool setMap(const QModbusDataUnitMap &map) override;

public Q_SLOTS:
    void updateReadings(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);

Q_SIGNALS:
    void journal(const gorizont::JournalEntry &entry);
    /// Once a second while somebody listens to this signal and somebody is connected, and once after the last one left.
    void clientsChanged(const QList<gorizont::ModbusClientInfo> &clients);

protected:
    bool open() override;
    void close() override;
    bool readData(QModbusDataUnit *unit) const override;
    bool writeData(const QModbusDataUnit &unit) override;

private:
    void onListening();
    void onListenFailed(QAbstractSocket::SocketError error, const QString &reason);
    void onConnected(QTcpSocket *socket);
    void admit(QTcpSocket *socket);
    void onEnded(ModbusPeer *peer, ModbusPeer::End how);
    void remove(ModbusPeer *peer);
    void dismiss(ModbusPeer *peer, ClientTrouble reason);
    void makeRoom();
    void lookAround();
    void dismissIdle(SteadyTime now);
    void publishClients();
    void tell(JournalKind kind, const QString &text);
    void tellTrouble(ClientTrouble trouble, const QHostAddress &address);

    const ModbusConfig m_config;
    const AllowList m_allowed;
    UnitImages m_images;
    ClientDiary m_diary;
    TcpListener m_listener;
    QTimer m_round; ///< once a second while connected
    std::vector<ModbusPeer *> m_peers; ///< children, in the order they came
    bool m_hasPublished = false; ///< the last clientsChanged() was not empty
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::ModbusClientInfo)
