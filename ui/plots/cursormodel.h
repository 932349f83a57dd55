#pragma once

#include "core/analysis/seriesstatistics.h"
#include "ui/plots/plottext.h"
#include "ui/plots/trendplot.h"

#include <QAbstractTableModel>

namespace gorizont {

/// What every curve does between the cursors A and B: one row a curve, in drawn units. GUI thread.
class CursorModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column {
        Curve,
        AtA,
        AtB,
        Difference,
        Mean,
        SlopeAnHour,
        SlopeADay,
        Minimum,
        Maximum,
        Completeness,
        ColumnCount
    };

    struct Row
    {
        TrendCurve curve;
        std::optional<double> atA; ///< in the unit of the quantity, like all below
        std::optional<double> atB;
        std::optional<SeriesStatistics> between;
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setRows(const QList<Row> &rows, TiltUnit unit);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const Row &row, int column) const;

    QList<Row> m_rows;
    TiltUnit m_unit = TiltUnit::Degrees;
};

/// The row of \a series between \a first and \a second, in whichever order they stand.
CursorModel::Row cursorRow(const TrendCurve &curve, const Series &series, UtcTime first, UtcTime second);

} // namespace gorizont
