#include "ui/plots/cursormodel.h"

#include "ui/models/valuetext.h"

#include <QPainter>
#include <QPixmap>

namespace gorizont {

namespace {

QPixmap lineSample(const CurveStyle &style)
{
    QPixmap sample(28, 12);
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setPen(QPen(style.colour, 2, style.line));
    painter.drawLine(0, 6, 28, 6);
    return sample;
}

} // namespace

CursorModel::Row cursorRow(const TrendCurve &curve, const Series &series, UtcTime first, UtcTime second)
{
    const auto [from, to] = std::minmax(first, second);
    return {
        curve, valueAt(series, first), valueAt(series, second),
        statistics(series, from, to + std::chrono::microseconds(1))};
}

void CursorModel::setRows(const QList<Row> &rows, TiltUnit unit)
{
    const bool isSameSize = rows.size() == m_rows.size() && !rows.isEmpty();
    if (!isSameSize) {
        beginResetModel();
    }
    m_rows = rows;
    m_unit = unit;
    if (isSameSize) {
        Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(m_rows.size()) - 1, ColumnCount - 1));
    } else {
        endResetModel();
    }
}

int CursorModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int CursorModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString CursorModel::text(const Row &row, int column) const
{
    const Quantity quantity = row.curve.key.quantity;
    const ValueAxis axis = plottext::axisOf(quantity);
    const double scale = plottext::scaleOf(quantity, m_unit);
    const auto plain = [&](std::optional<double> value) {
        return plottext::value(value ? std::optional(*value * scale) : value, axis, m_unit);
    };
    const auto change = [&](std::optional<double> value) {
        return plottext::signedValue(value ? std::optional(*value * scale) : value, axis, m_unit);
    };
    const auto of = [&row](auto member) {
        return row.between ? std::optional<double>(member(*row.between)) : std::nullopt;
    };
    switch (column) {
    case Curve: return QStringLiteral("%1, %2").arg(row.curve.title, plottext::unitOf(axis, m_unit));
    case AtA: return plain(row.atA);
    case AtB: return plain(row.atB);
    case Difference: return change(row.atA && row.atB ? std::optional(*row.atB - *row.atA) : std::nullopt);
    case Mean: return plain(of([](const SeriesStatistics &s) { return s.mean; }));
    case SlopeAnHour: return change(of([](const SeriesStatistics &s) { return s.slopeAnHour(); }));
    case SlopeADay: return change(of([](const SeriesStatistics &s) { return s.slope; }));
    case Minimum: return plain(of([](const SeriesStatistics &s) { return s.minimum; }));
    case Maximum: return plain(of([](const SeriesStatistics &s) { return s.maximum; }));
    case Completeness: return valuetext::fixed(of([](const SeriesStatistics &s) { return 100 * s.completeness; }), 1);
    default: return {};
    }
}

QVariant CursorModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Row &row = m_rows.at(index.row());
    switch (role) {
    case Qt::DisplayRole: return text(row, index.column());
    case Qt::DecorationRole: return index.column() == Curve ? QVariant(lineSample(row.curve.style)) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() == Curve ? Qt::AlignLeft : Qt::AlignRight));
    default: return {};
    }
}

QVariant CursorModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section == Curve ? Qt::AlignLeft : Qt::AlignRight));
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Mean: return tr("Mean of all valid readings between the cursors");
        case SlopeAnHour: return tr("Slope of the straight line of least squares, an hour");
        case SlopeADay: return tr("Slope of the straight line of least squares, a day");
        case Completeness: return tr("Share of the time between the cursors without gaps, %");
        default: return {};
        }
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Curve: return tr("Curve");
    case AtA: return QStringLiteral("A");
    case AtB: return QStringLiteral("B");
    case Difference: return QStringLiteral("B − A");
    case Mean: return tr("Mean");
    case SlopeAnHour: return tr("Slope / h");
    case SlopeADay: return tr("Slope / day");
    case Minimum: return tr("Min.");
    case Maximum: return tr("Max.");
    case Completeness: return tr("Complete, %");
    default: return {};
    }
}

} // namespace gorizont
