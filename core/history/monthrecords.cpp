#include "core/history/monthrecords.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr qsizetype linesOfLook = 64; ///< to find the first record or the period
constexpr qint64 endOfLook = 1 << 16; ///< bytes at the end that are searched for the last record
constexpr qint64 pieceSize = 1 << 17; ///< bytes that are read at once; a record of 1000 sensors is shorter

} // namespace

MonthRecords::MonthRecords(const QString &path, const QTimeZone &zone)
    : m_file(path)
    , m_zone(zone)
{
    if (m_file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        m_size = m_file.size();
    }
}

/// From \a offset up to and with the end of the line; a line that is longer than a piece is none of ours and comes cut.
/// Empty: the file ends there, or cannot be read. Good until the next call.
QByteArrayView MonthRecords::lineAt(qint64 offset) const
{
    for (const bool isFresh : {false, true}) {
        if (isFresh) {
            m_piece = m_file.seek(offset) ? m_file.read(pieceSize) : QByteArray();
            m_pieceAt = offset;
        }
        if (offset >= m_pieceAt && offset < m_pieceAt + m_piece.size()) {
            const QByteArrayView rest = QByteArrayView(m_piece).sliced(offset - m_pieceAt);
            const qsizetype end = rest.indexOf('\n');
            if (end >= 0 || isFresh) {
                return end >= 0 ? rest.first(end + 1) : rest;
            }
        }
    }
    return {};
}

qint64 MonthRecords::nextLine(qint64 offset) const
{
    const qsizetype length = lineAt(offset).size();
    return length > 0 ? offset + length : m_size;
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
std::optional<UtcTime> MonthRecords::timeFrom(qint64 offset) const
{
    for (qsizetype i = 0; i < linesOfLook && offset < m_size; ++i) {
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
    const qint64 from = std::max<qint64>(0, m_size - endOfLook);
    for (qint64 offset = from == 0 ? 0 : nextLine(from); offset < m_size; offset = nextLine(offset)) {
        if (const std::optional<HistoryRow> row = HistoryRow::parse(lineAt(offset))) {
            found = timeOf(*row);
        }
    }
    return found;
}

qsizetype MonthRecords::groups() const
{
    qint64 offset = 0;
    for (qsizetype i = 0; i < linesOfLook && offset < m_size; ++i) {
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
    qint64 offset = 0;
    for (qsizetype i = 0; i < linesOfLook && offset < m_size; ++i, offset = nextLine(offset)) {
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
qint64 MonthRecords::firstAtOrAfter(UtcTime time) const
{
    qint64 low = 0;
    qint64 high = m_size;
    while (high - low > endOfLook) {
        const qint64 middle = nextLine(low + (high - low) / 2);
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
    for (qint64 offset = firstAtOrAfter(from); offset < m_size; offset = nextLine(offset)) {
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
