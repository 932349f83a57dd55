#include "core/export/tableexport.h"

#include <algorithm>
#include <utility>

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
        const auto series = seriesBetween(from, to);
        if (!series || !writeRows(table, *series, from, to)
            || !report(double((to - begin).count()) / double((end - begin).count()))) {
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
std::optional<QList<Series>> TableExport::seriesBetween(UtcTime from, UtcTime to)
{
    const ExportEvery every = m_request.every;
    if (every == ExportEvery::Reading) {
        return wait(m_source.series({exportedSeries(m_request), from, to, 0}));
    }
    const auto step = every == ExportEvery::Minute ? std::chrono::minutes(1) : std::chrono::hours(1);
    auto series = wait(m_source.series({exportedSeries(m_request), from, to, static_cast<int>((to - from) / step)}));
    if (series) {
        for (Series &one : *series) {
            one.buckets = rolledUp(one.buckets, every, m_request.zone);
        }
    }
    return series;
}

bool TableExport::writeRows(const CsvTable &table, const QList<Series> &series, UtcTime from, UtcTime to)
{
    constexpr qsizetype portion = 1 << 20; // bytes that are written at once
    SeriesRows rows(series, from, to);
    QByteArray text;
    while (rows.next()) {
        text += table.row(rows.row());
        ++m_result.rows;
        if (text.size() >= portion && !write(std::exchange(text, {}))) {
            return false;
        }
    }
    return write(text);
}

} // namespace gorizont
