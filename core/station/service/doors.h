#pragma once

#include "core/line/openline.h"
#include "core/station/service/serialdoor.h"
#include "core/station/service/stationplan.h"
#include "core/station/service/tcpdoor.h"

#include <memory>
#include <vector>

namespace gorizont::station {

/// A place where a station waits for dispatchers over TCP.
struct ListenAddress
{
    QHostAddress address = QHostAddress(QHostAddress::LocalHost);
    quint16 port = 0; ///< 0: one that is free
    bool operator==(const ListenAddress &) const = default;

    /// `PORT` (this computer only), `ADDRESS:PORT`, `[IPV6]:PORT`. Empty: it is none of these.
    static std::optional<ListenAddress> from(const QString &text);
};

/// All ways by which dispatchers reach a station. Lives in the thread of the station.
class Doors : public QObject
{
    Q_OBJECT

public:
    Doors(const PortNaming &ports, Answerer answerer, QObject *parent = nullptr);

    /// Opens what is new and closes what is not wanted any more; the others keep their clients.
    void apply(const QList<DispatcherLine> &lines, const QList<ListenAddress> &listen);

    /// Of the TCP doors that are open, in their order.
    QList<quint16> tcpPorts() const;

Q_SIGNALS:
    /// \a text is a sentence for the journal.
    void stateChanged(bool isGood, const QString &text);

private:
    struct Serial
    {
        LineConfig line;
        std::unique_ptr<SerialDoor> door;
    };
    struct Tcp
    {
        ListenAddress address;
        std::unique_ptr<TcpDoor> door;
    };

    void openSerial(const LineConfig &line);
    void openTcp(const ListenAddress &address);

    PortNaming m_ports;
    Answerer m_answerer;
    std::vector<Serial> m_serials;
    std::vector<Tcp> m_tcps;
};

} // namespace gorizont::station
