#include "core/export/tableexport.h"

#include "core/export/csvtable.h"

#include <algorithm>

namespace gorizont {

using namespace std::chrono_literals;

bool TableExport::writeAll()
{
    const CsvTable table(m_request);
    const ExportEvery every = m_request.every;
    const UtcTime begin = beginOf(m_request.from, every, m_request.zone);
    const UtcTime end =
        every == ExportEvery::Reading ? m_request.to : nextAfter(m_request.to - 1us, every, m_request.zone);
    if (!write(table.header())) {
        return false;
    }
    for (UtcTime from = begin; from < end;) {
        const UtcTime to = std::min(end, pieceEnd(from));
        const auto rows = rowsBetween(from, to);
        if (!rows) {
            return false;
        }
        QByteArray text;
        for (const SeriesRow &row : *rows) {
            text += table.row(row);
        }
        m_result.rows += static_cast<quint64>(rows->size());
        if (!write(text) || !report(double((to - begin).count()) / double((end - begin).count()))) {
            return false;
        }
        from = to;
    }
    return true;
}

UtcTime TableExport::pieceEnd(UtcTime from) const
{
    switch (m_request.every) {
    case ExportEvery::Reading: return from + 1h;
    case ExportEvery::Minute: return from + 24h;
    case ExportEvery::Hour: return from + 31 * 24h;
    case ExportEvery::Day: break;
    }
    return beginOf(from + 366 * 24h, ExportEvery::Day, m_request.zone);
}

/// Days are put together of hours: they begin at midnight of the zone, which the archive need not know.
std::optional<QList<SeriesRow>> TableExport::rowsBetween(UtcTime from, UtcTime to)
{
    const ExportEvery every = m_request.every;
    const auto step = every == ExportEvery::Minute ? std::chrono::minutes(1) : std::chrono::hours(1);
    const bool isFull = every == ExportEvery::Reading;
    const int width = isFull ? 0 : static_cast<int>((to - from) / step);
    auto series = wait(m_source.series({exportedSeries(m_request), from, to, width}));
    if (!series) {
        return {};
    }
    for (Series &one : *series) {
        one.buckets = isFull ? one.buckets : rolledUp(one.buckets, every, m_request.zone);
    }
    return rowsOf(*series, from, to);
}

} // namespace gorizont
