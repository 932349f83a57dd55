#pragma once

#include "core/registry/sensorregistry.h"
#include "core/values/series.h"

#include <QAbstractItemModel>

namespace gorizont {

/// Sensor × quantity, each to be ticked: what can be drawn. Ticked ones stand in the order in which they were. GUI thread.
class CurveModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    /// More would have neither a colour nor a line of their own.
    static constexpr int mostCurves = 28;

    explicit CurveModel(const SensorRegistry &registry, QObject *parent = nullptr);

    const QList<SeriesKey> &chosen() const { return m_chosen; }
    /// Keys of unknown sensors are left out, and what exceeds mostCurves.
    void setChosen(const QList<SeriesKey> &keys);
    /// Adds what an operator wants to see first of a sensor: its angles, else what it measures.
    void addSensor(int number);

    bool isKnown(const SeriesKey &key) const;
    QModelIndex indexOf(const SeriesKey &key) const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

Q_SIGNALS:
    void chosenChanged();

private:
    struct Sensor
    {
        QString title;
        int number = 0;
        QList<Quantity> quantities;
    };
    std::optional<SeriesKey> keyOf(const QModelIndex &index) const; ///< empty: a sensor

    std::vector<Sensor> m_sensors;
    QList<SeriesKey> m_chosen;
};

} // namespace gorizont
