#include "ui/models/portmodel.h"

#include "ui/models/icons.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

namespace gorizont {

PortModel::PortModel(const SensorRegistry &registry, QObject *parent)
    : QAbstractTableModel(parent)
    , m_registry(registry)
    , m_now(std::chrono::steady_clock::now())
{
}

void PortModel::refresh(SteadyTime now)
{
    m_now = now;
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

int PortModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_registry.lines().size());
}

int PortModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PortModel::text(const SensorRegistry::Line &line, int column) const
{
    const LineStatus &status = line.status;
    switch (column) {
    case Port: return line.config.title();
    case State: return statetext::line(status.state);
    case Uptime: return status.openedAt ? valuetext::duration(m_now - *status.openedAt) : valuetext::absent();
    case Sent: return QString::number(status.bytesSent);
    case Received: return QString::number(status.bytesReceived);
    case Attempts: return QString::number(status.failedOpens);
    default: return {};
    }
}

/// Ports sort by their place in the ini: COM10 stands after COM9.
QVariant PortModel::sortKey(int row, int column) const
{
    const LineStatus &status = m_registry.lines()[static_cast<std::size_t>(row)].status;
    switch (column) {
    case State: return statetext::line(status.state);
    case Uptime: return status.openedAt ? QVariant(qint64((m_now - *status.openedAt).count())) : QVariant();
    case Sent: return status.bytesSent;
    case Received: return status.bytesReceived;
    case Attempts: return status.failedOpens;
    default: return row;
    }
}

QVariant PortModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const SensorRegistry::Line &line = m_registry.lines()[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole: return text(line, index.column());
    case Qt::DecorationRole:
        return index.column() == Port ? QVariant(icons::state(lineHealth(line.status.state))) : QVariant();
    case SortRole: return sortKey(index.row(), index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() >= Uptime ? Qt::AlignRight : Qt::AlignLeft));
    case Qt::ToolTipRole: return index.column() == State ? line.status.lastError : line.config.name;
    default: return {};
    }
}

QVariant PortModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section >= Uptime ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Port: return tr("Logical name of the port");
        case State: return tr("Present state of the port");
        case Uptime: return tr("How long the port has been open, h:mm:ss");
        case Sent: return tr("Bytes sent");
        case Received: return tr("Bytes received");
        case Attempts: return tr("Failed attempts to open the port");
        default: return {};
        }
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Port: return tr("Port");
    case State: return tr("State");
    case Uptime: return tr("Time");
    case Sent: return tr("Sent");
    case Received: return tr("Received");
    case Attempts: return tr("Attempts");
    default: return {};
    }
}

} // namespace gorizont
