#pragma once

#include "core/values/gap.h"
#include "core/values/sensorconfig.h"

#include <QAbstractTableModel>

namespace gorizont {

/// The gaps of the chosen days, one row each. GUI thread.
class GapModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Sensor, From, To, Length, Reason, FilledFrom, ColumnCount };

    static constexpr int SortRole = Qt::UserRole; ///< what a cell sorts by

    using QAbstractTableModel::QAbstractTableModel;

    void setSensors(const QList<SensorConfig> &sensors) { m_sensors = sensors; }
    void setGaps(const QList<Gap> &gaps, UtcTime now); ///< those that go on are counted up to \a now

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const Gap &gap, int column) const;
    QVariant sortKey(const Gap &gap, int column) const;
    UtcTime::duration lengthOf(const Gap &gap) const;

    QList<SensorConfig> m_sensors;
    QList<Gap> m_gaps;
    UtcTime m_now;
};

/// Why there is no data, in words.
QString gapReasonText(GapReason reason);

} // namespace gorizont
