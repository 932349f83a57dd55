#pragma once

#include "ui/weather/precipitation.h"

#include <QAbstractTableModel>

namespace gorizont {

/// Begin, end and duration of what a station remembers of rain, newest first. GUI thread.
class PrecipitationModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Begin, End, Duration, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setSpells(const QList<Precipitation> &spells, precipitation::StationClock clock);
    /// How long it rains is counted up to \a now, seconds of the station.
    void setNow(qint64 now);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const Precipitation &spell, int column) const;
    QString time(std::optional<qint64> seconds) const;

    QList<Precipitation> m_spells;
    precipitation::StationClock m_clock = precipitation::StationClock::Local;
    qint64 m_now = 0;
};

} // namespace gorizont
