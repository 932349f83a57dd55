#include "ui/plots/trendcsv.h"

namespace gorizont {

QByteArray trendCsv(const QList<CsvCurve> &curves, const TimeSpan &span, ExportFormat format, const QTimeZone &zone)
{
    QList<CsvColumn> columns;
    QList<Series> series;
    for (const CsvCurve &curve : curves) {
        columns.append(curve.column);
        series.append(curve.series);
    }
    const CsvTable table(format, zone, columns);
    QByteArray text = table.header();
    SeriesRows rows(series, span.from, span.to);
    while (rows.next()) {
        text += table.row(rows.row());
    }
    return text;
}

} // namespace gorizont
