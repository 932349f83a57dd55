#pragma once

#include "core/export/csvtable.h"

namespace gorizont {

/// A curve as it goes into a table.
struct CsvCurve
{
    CsvColumn column;
    Series series;
};

/// The curves as every table of the program: one row for every moment in from ≤ t < to at which one of them has a valid
/// value, three columns where a bucket is a stretch. Pure.
QByteArray trendCsv(const QList<CsvCurve> &curves, const TimeSpan &span, ExportFormat format, const QTimeZone &zone);

} // namespace gorizont
