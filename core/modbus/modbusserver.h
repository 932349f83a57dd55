#pragma once

#include "core/modbus/modbusanswer.h"
#include "core/net/clientdesk.h"

#include <QModbusServer>

namespace gorizont {

/// Serves units 1, 3 and 6 over Modbus TCP (manual 000, section 10; spec/gorizont.md, section 6). Servers thread.
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

    /// The clients, and what the journal is told. It lives in the thread of the server.
    ClientDesk &desk() { return m_desk; }
    quint16 serverPort() const { return m_desk.port(); } ///< 0: not listening

    /// The images are the only registers there are: this base-class door only reads. data() shows the input registers of
    /// unit serverAddress(), at first 3.
    bool setMap(const QModbusDataUnitMap &map) override;

public Q_SLOTS:
    void updateReadings(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);

protected:
    bool open() override;
    void close() override;
    bool readData(QModbusDataUnit *unit) const override;
    bool writeData(const QModbusDataUnit &unit) override;

private:
    void tellUnreachable();

    UnitImages m_images;
    ClientDesk m_desk; ///< after the images: its peers read them
};

} // namespace gorizont
