#pragma once

#include "core/values/series.h"

#include <QByteArray>
#include <QString>
#include <QTimeZone>

namespace gorizont {

/// A curve as it goes into a table.
struct CsvCurve
{
    QString title;
    QString unit;
    double scale = 1; ///< written = value × scale
    Series series;
};

/// How a table is read: by Excel with Russian settings (`;`, decimal comma, byte order mark, local time), or by programs
/// (`,`, decimal point, ISO 8601 with the offset from UTC).
enum class CsvForm : quint8 { RussianExcel, Iso };

/// One row for every moment in from ≤ t < to at which a curve has a bucket, one column for each curve, three where a
/// bucket is a stretch: mean, min, max. A field without a valid value is empty. UTF-8, lines end with CRLF. Pure.
QByteArray trendCsv(const QList<CsvCurve> &curves, const TimeSpan &span, CsvForm form, const QTimeZone &zone);

} // namespace gorizont
