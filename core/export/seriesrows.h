#pragma once

#include "core/export/exportrequest.h"

namespace gorizont {

/// A table row: what is known at one moment, or of one stretch of time that begins then. Pure.
struct SeriesRow
{
    UtcTime time;
    QList<std::optional<SeriesBucket>> cells; ///< one for each series; empty: no valid value
};

/// The beginning of the minute, hour or day that \a time lies in; \a zone decides where days begin. Reading: \a time.
UtcTime beginOf(UtcTime time, ExportEvery every, const QTimeZone &zone);

/// The beginning of the next one. Not for Reading.
UtcTime nextAfter(UtcTime time, ExportEvery every, const QTimeZone &zone);

/// \a buckets, in ascending time, put together to one for each minute, hour or day that has valid values.
QList<SeriesBucket> rolledUp(const QList<SeriesBucket> &buckets, ExportEvery every, const QTimeZone &zone);

/// The rows of \a series, in ascending time; moments without any valid value have none. Moments before \a from and from
/// \a to on are left out.
QList<SeriesRow> rowsOf(const QList<Series> &series, UtcTime from, UtcTime to);

} // namespace gorizont
