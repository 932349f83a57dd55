#include "core/modbus/modbusserver.h"

#include "core/protocol/bytes.h"

namespace gorizont {

namespace {

/// Bytes a turn: sixteen reads. However many a client sends at once, the others wait for no more than that.
constexpr qint64 readLimit = 16 * 12;

Service modbusService(const UnitImages &images)
{
    Service service;
    service.name = QStringLiteral("Modbus TCP");
    service.portKey = QStringLiteral("IPPort1");
    service.readLimit = readLimit;
    service.answer = [&images](QByteArrayView received, AnswerBuffer &answers) {
        return answerRequests(received, images, answers);
    };
    return service;
}

} // namespace

ModbusServer::ModbusServer(const ModbusConfig &config, QObject *parent)
    : QModbusServer(parent)
    , m_images(config)
    , m_desk(modbusService(m_images), config.desk, this)
{
    setServerAddress(UnitImages::tiltUnit);
    setConnectionParameter(NetworkPortParameter, config.port);
    setConnectionParameter(NetworkAddressParameter, config.desk.bind);
    connect(&m_desk, &ClientDesk::listening, this, [this] { setState(ConnectedState); });
    connect(&m_desk, &ClientDesk::listenFailed, this, [this] { setError(m_desk.problem(), ConnectionError); });
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
    const auto port = static_cast<quint16>(connectionParameter(NetworkPortParameter).toInt());
    tellUnreachable();
    if (!m_desk.open(bind, port)) {
        setError(m_desk.problem(), ConfigurationError);
        return false;
    }
    return true;
}

void ModbusServer::tellUnreachable()
{
    if (!m_images.unreachable().isEmpty()) {
        m_desk.tell(JournalKind::Error, m_images.unreachable().sentence());
    }
}

void ModbusServer::close()
{
    m_desk.close();
    setState(UnconnectedState);
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
