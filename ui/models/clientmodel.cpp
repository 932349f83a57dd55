#include "ui/models/clientmodel.h"

#include "ui/models/valuetext.h"

#include <algorithm>

namespace gorizont {

namespace {

bool isSameConnection(const ClientInfo &a, const ClientInfo &b)
{
    return a.port == b.port && a.address == b.address;
}

/// Addresses by their numbers: 10.0.0.9 stands before 10.0.0.10.
QString addressKey(const ClientInfo &client)
{
    const Q_IPV6ADDR bytes = client.address.toIPv6Address();
    const QByteArray raw(reinterpret_cast<const char *>(bytes.c), sizeof bytes.c);
    return QString::fromLatin1(raw.toHex()) + QStringLiteral("%1").arg(client.port, 5, 10, QLatin1Char('0'));
}

QVariant sortKey(const ClientModel::Client &client, int column)
{
    const ClientInfo &info = client.info;
    switch (column) {
    case ClientModel::Service: return client.service;
    case ClientModel::Address: return addressKey(info);
    case ClientModel::Since: return qint64(info.since.time_since_epoch().count());
    case ClientModel::Requests: return info.requests;
    case ClientModel::LastRequest: // the youngest first
        return info.lastRequest ? QVariant(-qint64(info.lastRequest->time_since_epoch().count())) : QVariant();
    case ClientModel::Errors: return info.errors;
    case ClientModel::Received: return info.bytesReceived;
    case ClientModel::Sent: return info.bytesSent;
    default: return {};
    }
}

} // namespace

QString clientTitle(const ClientInfo &client)
{
    const bool isLong = client.address.protocol() == QAbstractSocket::IPv6Protocol;
    return (isLong ? QStringLiteral("[%1]:%2") : QStringLiteral("%1:%2"))
        .arg(client.address.toString())
        .arg(client.port);
}

void ClientModel::setClients(const QString &service, const QList<ClientInfo> &clients)
{
    const auto added = static_cast<int>(clients.size() - keep(service, clients));
    if (added > 0) {
        beginInsertRows({}, rowCount(), rowCount() + added - 1);
        for (const ClientInfo &client : clients.last(added)) {
            m_clients.push_back({service, client});
        }
        endInsertRows();
    }
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

/// Updates who is still there and removes who has gone. Both lists are in the order the clients came, so one pass does.
/// How many of \a clients, from the first on, have their rows now.
qsizetype ClientModel::keep(const QString &service, const QList<ClientInfo> &clients)
{
    qsizetype kept = 0;
    for (int row = 0; row < rowCount();) {
        Client &shown = m_clients[static_cast<std::size_t>(row)];
        if (shown.service != service) {
            ++row;
        } else if (kept < clients.size() && isSameConnection(shown.info, clients.at(kept))) {
            shown.info = clients.at(kept);
            ++kept;
            ++row;
        } else {
            beginRemoveRows({}, row, row);
            m_clients.erase(m_clients.begin() + row);
            endRemoveRows();
        }
    }
    return kept;
}

void ClientModel::refresh(UtcTime now)
{
    m_now = now;
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, LastRequest), index(rowCount() - 1, LastRequest));
    }
}

int ClientModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_clients.size());
}

int ClientModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString ClientModel::text(const Client &client, int column) const
{
    const ClientInfo &info = client.info;
    switch (column) {
    case Service: return client.service;
    case Address: return clientTitle(info);
    case Since: return valuetext::clock(info.since);
    case Requests: return QString::number(info.requests);
    case LastRequest: // the clock of the system may have been set back meanwhile
        return info.lastRequest ? valuetext::age(std::max(m_now - *info.lastRequest, UtcTime::duration::zero()))
                                : valuetext::absent();
    case Errors: return QString::number(info.errors);
    case Received: return QString::number(info.bytesReceived);
    case Sent: return QString::number(info.bytesSent);
    default: return {};
    }
}

QVariant ClientModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole: return text(client(index.row()), index.column());
    case SortRole: return sortKey(client(index.row()), index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() >= Requests ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
    }
}

QVariant ClientModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section >= Requests ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
        return {};
    }
    const bool isTip = role == Qt::ToolTipRole;
    switch (section) {
    case Service: return isTip ? tr("What the client is connected to") : tr("Service");
    case Address: return isTip ? tr("Address and port of the client") : tr("Client");
    case Since: return isTip ? tr("When the client connected") : tr("Since");
    case Requests: return isTip ? tr("Requests answered") : tr("Requests");
    case LastRequest: return isTip ? tr("How long ago the last request came") : tr("Last");
    case Errors: return isTip ? tr("Requests answered with an exception or not at all") : tr("Errors");
    case Received: return isTip ? tr("Bytes received from the client") : tr("Received");
    case Sent: return isTip ? tr("Bytes sent to the client") : tr("Sent");
    default: return {};
    }
}

} // namespace gorizont
