#include "core/net/desksentences.h"

#include <QDateTime>

namespace gorizont {

DeskSentences::DeskSentences(const QString &service, const QString &portKey)
    : m_service(service)
    , m_portKey(portKey)
{
}

QString DeskSentences::listening(quint16 port) const
{
    return tr("%1: serving on port %2.").arg(m_service, QString::number(port));
}

QString DeskSentences::stopped() const
{
    return tr("%1: stopped.").arg(m_service);
}

QString DeskSentences::cannotListen(
    int port, QAbstractSocket::SocketError error, const QString &reason, std::chrono::seconds retry) const
{
    return tr("%1: cannot serve on port %2 (%3). %4 Trying again every %5 s.")
        .arg(m_service, QString::number(port), reason, listenRemedy(error), QString::number(retry.count()));
}

QString DeskSentences::listenRemedy(QAbstractSocket::SocketError error) const
{
    switch (error) {
    case QAbstractSocket::AddressInUseError:
        return tr("Another program uses this port. Stop that program or choose another %1.").arg(m_portKey);
    case QAbstractSocket::SocketAccessError:
        return tr("Ports below 1024 need a right. Choose another %1, or give the right once: sudo setcap "
                  "cap_net_bind_service=+ep %2")
            .arg(m_portKey, QCoreApplication::applicationFilePath());
    case QAbstractSocket::SocketAddressNotAvailableError:
        return tr("This computer does not have the address given in ModbusBind.");
    default: return tr("Check %1 and ModbusBind.").arg(m_portKey);
    }
}

QString DeskSentences::badBindAddress(const QString &text) const
{
    return tr("%1: \"%2\" in ModbusBind is not an IP address. Not serving until it is corrected.").arg(m_service, text);
}

QString DeskSentences::badAllowEntry(const QString &text) const
{
    return tr("%1: \"%2\" in ModbusAllow is neither an address nor a block of addresses. It is left out.")
        .arg(m_service, text);
}

QString DeskSentences::cannotAccept(const QString &reason) const
{
    return tr("%1: new clients cannot be accepted (%2). Those connected are served on. Trying again every second.")
        .arg(m_service, reason);
}

QString DeskSentences::acceptsAgain() const
{
    return tr("%1: new clients are accepted again.").arg(m_service);
}

QString DeskSentences::came(const QHostAddress &address) const
{
    return tr("%1: client %2 connected.").arg(m_service, address.toString());
}

QString DeskSentences::gone(const QHostAddress &address, UtcTime left) const
{
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(left.time_since_epoch());
    const QString time = QDateTime::fromMSecsSinceEpoch(ms.count()).toString(QStringLiteral("HH:mm:ss"));
    return tr("%1: client %2 has not been here since %3.").arg(m_service, address.toString(), time);
}

QString DeskSentences::cutOff(const QHostAddress &address, quint16 port) const
{
    return tr("%1: client %2 (its port %3) was cut off by the operator.")
        .arg(m_service, address.toString(), QString::number(port));
}

QString DeskSentences::trouble(ClientTrouble trouble, const QHostAddress &address) const
{
    const auto sentence = [trouble] {
        switch (trouble) {
        case ClientTrouble::Refused: return tr("%1: client %2 was refused: ModbusAllow does not list it.");
        case ClientTrouble::Malformed:
            return tr("%1: client %2 was disconnected: it does not speak %1 (wrong length of a request).");
        case ClientTrouble::Unanswered:
            return tr("%1: client %2 sends what is no request (wrong length, address or command) and gets no answer.");
        case ClientTrouble::Stalled:
            return tr("%1: client %2 was disconnected: it asks and does not read the answers.");
        case ClientTrouble::Idle:
            return tr("%1: client %2 was disconnected: it asked nothing for longer than ModbusIdle.");
        case ClientTrouble::GaveWay:
            return tr("%1: client %2 was disconnected to make room: as many clients as ModbusClients allows, and it "
                      "was silent the longest.");
        }
        return QString();
    };
    return sentence().arg(m_service, address.toString());
}

} // namespace gorizont
