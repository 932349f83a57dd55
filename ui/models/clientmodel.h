#pragma once

#include "core/net/clientinfo.h"

#include <QAbstractTableModel>

#include <vector>

namespace gorizont {

/// The table <Клиенты>, one row a connection in the order they came. GUI thread.
class ClientModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Service, Address, Since, Requests, LastRequest, Errors, Received, Sent, ColumnCount };

    static constexpr int SortRole = Qt::UserRole; ///< what a cell sorts by; invalid: absent

    struct Client
    {
        QString service; ///< as its desk calls it
        ClientInfo info;
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// All clients of \a service as they are now; those of other services stay. Rows of who is still there stay too.
    void setClients(const QString &service, const QList<ClientInfo> &clients);
    /// Counts the ages up to \a now.
    void refresh(UtcTime now);

    const Client &client(int row) const { return m_clients[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const Client &client, int column) const;
    qsizetype keep(const QString &service, const QList<ClientInfo> &clients);

    std::vector<Client> m_clients;
    UtcTime m_now = utcNow();
};

/// `192.168.1.20:50211`, `[fe80::1]:50211`.
QString clientTitle(const ClientInfo &client);

} // namespace gorizont
