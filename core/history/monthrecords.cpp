#include "core/history/monthrecords.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr qsizetype linesOfLook = 64; ///< to find the first record or the period
constexpr qsizetype endOfLook = 1 << 16; ///< bytes at the end that are searched for the last record

} // namespace

MonthRecords::MonthRecords(const QString &path, const QTimeZone &zone)
    : m_file(path)
    , m_zone(zone)
{
    if (m_file.open(QIODevice::ReadOnly) && m_file.size() > 0) {
        if (const uchar *bytes = m_file.map(0, m_file.size())) {
            m_text = QByteArrayView(bytes, m_file.size());
        }
    }
}

QByteArrayView MonthRecords::lineAt(qsizetype offset) const
{
    return m_text.sliced(offset, nextLine(offset) - offset);
}

qsizetype MonthRecords::nextLine(qsizetype offset) const
{
    const qsizetype end = m_text.indexOf('\n', offset);
    return end < 0 ? m_text.size() : end + 1;
}

std::optional<UtcTime> MonthRecords::timeOf(const HistoryRow &row) const
{
    if (row.date() != m_day || row.time().hour() != m_hour) {
        m_day = row.date();
        m_hour = row.time().hour();
        const QDateTime hour(m_day, QTime(m_hour, 0), m_zone);
        m_hourStart = UtcTime(std::chrono::milliseconds(hour.toMSecsSinceEpoch()));
    }
    return m_hourStart + std::chrono::seconds(row.time().minute() * 60 + row.time().second());
}

/// Of the first record that begins at or behind \a offset, which is the start of a line.
std::optional<UtcTime> MonthRecords::timeFrom(qsizetype offset) const
{
    for (qsizetype i = 0; i < linesOfLook && offset < m_text.size(); ++i) {
        if (const std::optional<HistoryRow> row = HistoryRow::parse(lineAt(offset))) {
            return timeOf(*row);
        }
        offset = nextLine(offset);
    }
    return {};
}

std::optional<UtcTime> MonthRecords::first() const
{
    return timeFrom(0);
}

std::optional<UtcTime> MonthRecords::last() const
{
    std::optional<UtcTime> found;
    const qsizetype from = std::max<qsizetype>(0, m_text.size() - endOfLook);
    for (qsizetype offset = from == 0 ? 0 : nextLine(from); offset < m_text.size(); offset = nextLine(offset)) {
        if (const std::optional<HistoryRow> row = HistoryRow::parse(lineAt(offset))) {
            found = timeOf(*row);
        }
    }
    return found;
}

qsizetype MonthRecords::groups() const
{
    qsizetype offset = 0;
    for (qsizetype i = 0; i < linesOfLook && offset < m_text.size(); ++i) {
        if (const std::optional<HistoryRow> row = HistoryRow::parse(lineAt(offset))) {
            return row->groups();
        }
        offset = nextLine(offset);
    }
    return 0;
}

std::chrono::microseconds MonthRecords::period() const
{
    QList<std::chrono::microseconds> distances;
    std::optional<UtcTime> before;
    qsizetype offset = 0;
    for (qsizetype i = 0; i < linesOfLook && offset < m_text.size(); ++i, offset = nextLine(offset)) {
        if (const std::optional<HistoryRow> row = HistoryRow::parse(lineAt(offset))) {
            const std::optional<UtcTime> time = timeOf(*row);
            if (before && *time > *before) {
                distances.append(*time - *before);
            }
            before = time;
        }
    }
    if (distances.isEmpty()) {
        return std::chrono::seconds(1);
    }
    const auto middle = distances.begin() + distances.size() / 2;
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

/// By bisection: the start of the line from which on records are to be read.
qsizetype MonthRecords::firstAtOrAfter(UtcTime time) const
{
    qsizetype low = 0;
    qsizetype high = m_text.size();
    while (high - low > endOfLook) {
        const qsizetype middle = nextLine(low + (high - low) / 2);
        const std::optional<UtcTime> there = middle < high ? timeFrom(middle) : std::nullopt;
        if (there && *there < time) {
            low = middle;
        } else {
            high = low + (high - low) / 2;
        }
    }
    return low;
}

void MonthRecords::read(UtcTime from, UtcTime to, const Take &take) const
{
    for (qsizetype offset = firstAtOrAfter(from); offset < m_text.size(); offset = nextLine(offset)) {
        const std::optional<HistoryRow> row = HistoryRow::parse(lineAt(offset));
        const std::optional<UtcTime> time = row ? timeOf(*row) : std::nullopt;
        if (!time || *time < from) {
            continue;
        }
        if (*time >= to || !take(*time, *row)) {
            return;
        }
    }
}

} // namespace gorizont
