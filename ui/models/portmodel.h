#pragma once

#include "core/registry/sensorregistry.h"

#include <QAbstractTableModel>

namespace gorizont {

/// The table <Порты>, one row a port in the order of the ini (manual 000, section 4.2). GUI thread.
class PortModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Port, State, Uptime, Sent, Received, Attempts, ColumnCount };

    static constexpr int SortRole = Qt::UserRole; ///< what a cell sorts by; invalid: absent

    explicit PortModel(const SensorRegistry &registry, QObject *parent = nullptr);

    /// Shows the registry as it is at \a now. Sixteen rows at most: all of them.
    void refresh(SteadyTime now);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const SensorRegistry::Line &line, int column) const;
    QVariant sortKey(int row, int column) const;

    const SensorRegistry &m_registry;
    SteadyTime m_now;
};

} // namespace gorizont
