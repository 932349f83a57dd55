#include "core/station/service/doors.h"

#include <QUrl>

#include <algorithm>

namespace gorizont::station {

std::optional<ListenAddress> ListenAddress::from(const QString &text)
{
    bool isNumber = false;
    if (const uint port = text.toUInt(&isNumber); isNumber) {
        return port <= 65535 ? std::optional(ListenAddress{QHostAddress(QHostAddress::LocalHost), quint16(port)})
                             : std::nullopt;
    }
    const QUrl url(QStringLiteral("tcp://") + text, QUrl::StrictMode);
    const QHostAddress address(url.host());
    if (!url.isValid() || url.port() < 0 || address.isNull()) {
        return std::nullopt;
    }
    return ListenAddress{address, static_cast<quint16>(url.port())};
}

Doors::Doors(const PortNaming &ports, Answerer answerer, QObject *parent)
    : QObject(parent)
    , m_ports(ports)
    , m_answerer(std::move(answerer))
{
}

void Doors::apply(const QList<DispatcherLine> &lines, const QList<ListenAddress> &listen)
{
    QList<LineConfig> serials;
    QList<ListenAddress> addresses = listen;
    for (const DispatcherLine &line : lines) {
        if (!line.isListening) {
            serials.append(line.line);
        } else if (const auto address = ListenAddress::from(QString(line.line.device).remove(0, 6))) {
            addresses.append(*address);
        } else {
            Q_EMIT stateChanged(
                false,
                tr("%1 is no place to listen: tcp://ADDRESS:PORT with an address in digits is.").arg(line.line.device));
        }
    }
    std::erase_if(m_serials, [&serials](const Serial &known) { return !serials.contains(known.line); });
    std::erase_if(m_tcps, [&addresses](const Tcp &known) { return !addresses.contains(known.address); });
    for (const LineConfig &line : serials) {
        if (std::none_of(m_serials.begin(), m_serials.end(), [&](const Serial &known) { return known.line == line; })) {
            openSerial(line);
        }
    }
    for (const ListenAddress &address : addresses) {
        if (std::none_of(m_tcps.begin(), m_tcps.end(), [&](const Tcp &known) { return known.address == address; })) {
            openTcp(address);
        }
    }
}

void Doors::openSerial(const LineConfig &line)
{
    auto door = std::make_unique<SerialDoor>(deviceName(line, m_ports), line, m_answerer);
    connect(door.get(), &SerialDoor::stateChanged, this, &Doors::stateChanged);
    door->open();
    m_serials.push_back({line, std::move(door)});
}

void Doors::openTcp(const ListenAddress &address)
{
    auto door = std::make_unique<TcpDoor>(address.address, address.port, m_answerer);
    connect(door.get(), &TcpDoor::stateChanged, this, &Doors::stateChanged);
    door->open();
    m_tcps.push_back({address, std::move(door)});
}

QList<quint16> Doors::tcpPorts() const
{
    QList<quint16> ports;
    for (const Tcp &tcp : m_tcps) {
        ports.append(tcp.door->port());
    }
    return ports;
}

} // namespace gorizont::station
