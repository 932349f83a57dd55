#pragma once

#include "core/values/weather.h"

#include <QAbstractTableModel>

namespace gorizont {

/// The parameters of a weather station, one row each in the order of its ACK.PAR. GUI thread.
class WeatherModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column {
        Name,
        Code,
        Unit,
        Mean,
        Instant,
        Minimum,
        Maximum,
        MaxPeriod,
        Deviation,
        Voltage,
        VoltageInstant,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// \a isValid: the values are to be believed; otherwise every one is absent.
    void setParameters(const QList<WeatherParameter> &parameters, bool isValid);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const WeatherParameter &parameter, int column) const;

    QList<WeatherParameter> m_parameters;
    bool m_isValid = false;
};

} // namespace gorizont
