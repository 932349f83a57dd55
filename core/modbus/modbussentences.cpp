#include "core/modbus/modbussentences.h"

#include <QCoreApplication>
#include <QDateTime>

namespace gorizont::modbussentence {

namespace {

QString listenRemedy(QAbstractSocket::SocketError error)
{
    switch (error) {
    case QAbstractSocket::AddressInUseError:
        return QCoreApplication::translate(
            "Modbus", "Another program uses this port. Stop that program or choose another IPPort1.");
    case QAbstractSocket::SocketAccessError:
        return QCoreApplication::translate(
                   "Modbus",
                   "Ports below 1024 need a right. Choose another IPPort1, or give the right once: sudo setcap "
                   "cap_net_bind_service=+ep %1")
            .arg(QCoreApplication::applicationFilePath());
    case QAbstractSocket::SocketAddressNotAvailableError:
        return QCoreApplication::translate("Modbus", "This computer does not have the address given in ModbusBind.");
    default: return QCoreApplication::translate("Modbus", "Check IPPort1 and ModbusBind.");
    }
}

} // namespace

QString listening(quint16 port)
{
    return QCoreApplication::translate("Modbus", "Modbus TCP: serving on port %1.").arg(port);
}

QString stopped()
{
    return QCoreApplication::translate("Modbus", "Modbus TCP: stopped.");
}

QString cannotListen(int port, QAbstractSocket::SocketError error, const QString &reason, std::chrono::seconds retry)
{
    return QCoreApplication::translate(
               "Modbus", "Modbus TCP: cannot serve on port %1 (%2). %3 Trying again every %4 s.")
        .arg(QString::number(port), reason, listenRemedy(error), QString::number(retry.count()));
}

QString badBindAddress(const QString &text)
{
    return QCoreApplication::translate(
               "Modbus", "Modbus TCP: \"%1\" in ModbusBind is not an IP address. Not serving until it is corrected.")
        .arg(text);
}

QString badAllowEntry(const QString &text)
{
    return QCoreApplication::translate(
               "Modbus",
               "Modbus TCP: \"%1\" in ModbusAllow is neither an address nor a block of addresses. It is "
               "left out.")
        .arg(text);
}

QString unreachableSensors(const QList<int> &numbers)
{
    return QCoreApplication::translate(
               "Modbus",
               "Modbus TCP: %1 sensors, the first of them N=%2, find no room below register 65536 and are "
               "not served.")
        .arg(numbers.size())
        .arg(numbers.value(0));
}

QString cannotAccept(const QString &reason)
{
    return QCoreApplication::translate(
               "Modbus",
               "Modbus TCP: new clients cannot be accepted (%1). Those connected are served on. Trying "
               "again every second.")
        .arg(reason);
}

QString acceptsAgain()
{
    return QCoreApplication::translate("Modbus", "Modbus TCP: new clients are accepted again.");
}

QString came(const QHostAddress &address)
{
    return QCoreApplication::translate("Modbus", "Modbus client %1 connected.").arg(address.toString());
}

QString gone(const QHostAddress &address, UtcTime left)
{
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(left.time_since_epoch());
    const QString time = QDateTime::fromMSecsSinceEpoch(ms.count()).toString(QStringLiteral("HH:mm:ss"));
    return QCoreApplication::translate("Modbus", "Modbus client %1 has not been here since %2.")
        .arg(address.toString(), time);
}

QString trouble(ClientTrouble trouble, const QHostAddress &address)
{
    const auto sentence = [trouble] {
        switch (trouble) {
        case ClientTrouble::Refused:
            return QCoreApplication::translate("Modbus", "Modbus client %1 was refused: ModbusAllow does not list it.");
        case ClientTrouble::Malformed:
            return QCoreApplication::translate(
                "Modbus",
                "Modbus client %1 was disconnected: it does not speak Modbus TCP (wrong length of a "
                "request).");
        case ClientTrouble::Stalled:
            return QCoreApplication::translate(
                "Modbus", "Modbus client %1 was disconnected: it asks and does not read the answers.");
        case ClientTrouble::Idle:
            return QCoreApplication::translate(
                "Modbus", "Modbus client %1 was disconnected: it asked nothing for longer than ModbusIdle.");
        case ClientTrouble::GaveWay:
            return QCoreApplication::translate(
                "Modbus",
                "Modbus client %1 was disconnected to make room: as many clients as ModbusClients allows, and "
                "it was silent the longest.");
        }
        return QString();
    };
    return sentence().arg(address.toString());
}

} // namespace gorizont::modbussentence
