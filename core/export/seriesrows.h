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

/// The rows of several series in ascending time, one after the other: all of them at once would need many times the
/// memory of the series. Moments without any valid value have no row. Pure.
class SeriesRows
{
public:
    /// \a series outlives this. Moments before \a from and from \a to on are left out.
    SeriesRows(const QList<Series> &series, UtcTime from, UtcTime to);

    /// False: there is no further row.
    bool next();
    const SeriesRow &row() const { return m_row; }

private:
    const QList<Series> &m_series;
    const UtcTime m_from;
    const UtcTime m_to;
    QList<qsizetype> m_at; ///< the next bucket of each series
    SeriesRow m_row;
};

} // namespace gorizont
