#pragma once

#include "ui/models/health.h"

#include <QAbstractTableModel>

#include <vector>

namespace gorizont {

/// The table <Датчики>, one row a sensor (manual 000, section 4.3), over the registry. It announces only the rows that
/// are looked at, so that thousands of changing sensors cost what one screen of them costs. Sorts itself, numbers as
/// numbers, with absent values last in either direction. GUI thread.
class SensorModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Sensor, Mx, My, Amax, Arms, Temperature, Fan, Power, Status, ColumnCount };

    explicit SensorModel(const SensorRegistry &registry, QObject *parent = nullptr);

    int sensorAt(int row) const { return m_order.at(static_cast<std::size_t>(row)); } ///< index into sensors()
    int rowOf(int sensor) const;

    /// Shows the registry as it is now in rows \a first … \a last.
    void refresh(int first, int last);
    /// Puts the rows in order again if values have moved them.
    void resort();

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

private:
    const SensorRegistry::Sensor &sensorOf(int index) const
    {
        return m_registry.sensors()[static_cast<std::size_t>(index)];
    }
    Health healthOf(const SensorRegistry::Sensor &sensor) const;
    QString toolTip(const SensorRegistry::Sensor &sensor, int column) const;
    std::vector<int> sortedOrder() const;
    void setOrder(std::vector<int> order);

    const SensorRegistry &m_registry;
    std::vector<int> m_order; ///< row → index into sensors()
    int m_sortColumn = Sensor;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
};

} // namespace gorizont
