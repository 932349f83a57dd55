#pragma once

#include "core/registry/sensorregistry.h"

#include <QAbstractTableModel>

#include <deque>

namespace gorizont {

/// The tab <Измерения>: the last lines of `_data` (manual 000, section 4.9; spec/gorizont.md, section 3), one field a
/// column, so that a copied row is the line of the file. GUI thread.
class MeasurementModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    static constexpr int leadingColumns = 2; ///< time and channel word
    static constexpr int sensorColumns = 5; ///< X, Y, T, heater power, status

    /// Keeps at most \a capacity lines; when there are more, the \a removed oldest go.
    MeasurementModel(const SensorRegistry &registry, int capacity, int removed, QObject *parent = nullptr);

    /// A line of `_data`, with or without its line end.
    void append(const QString &line);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Line
    {
        QString text;
        QList<int> ends; ///< positions after the fields
        QStringView field(int column) const;
    };
    static Line split(const QString &line);
    QString heading(int column) const;
    QString meaning(int column) const;

    std::deque<Line> m_lines;
    struct Sensor
    {
        int number = 0; ///< N
        QString title;
    };
    QList<Sensor> m_sensors; ///< those that measure tilt, in the order of their columns
    int m_capacity;
    int m_removed;
};

} // namespace gorizont
