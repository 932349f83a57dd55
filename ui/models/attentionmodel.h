#pragma once

#include "core/alarms/alarm.h"

#include <QAbstractTableModel>

namespace gorizont {

/// The messages that wait for the dispatcher, one row each, the oldest first. GUI thread.
class AttentionModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Began, Subject, Place, Meaning, Advice, ColumnCount };
    static constexpr int SortRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    /// Takes over the list as it is now; rows that stay keep their selection. \a alarms ascend by id.
    void setAlarms(const Alarms &alarms);
    const Alarm &alarmAt(int row) const { return m_alarms.at(row); }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    void removeMissing(const Alarms &alarms);

    Alarms m_alarms;
};

} // namespace gorizont
