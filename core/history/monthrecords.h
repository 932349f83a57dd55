#pragma once

#include "core/history/historyparser.h"
#include "core/values/timing.h"

#include <QFile>
#include <QTimeZone>

#include <functional>

namespace gorizont {

/// One text file of a month, read where it is wanted only: its records stand in ascending time. Any one thread.
class MonthRecords
{
public:
    MonthRecords(const QString &path, const QTimeZone &zone);

    bool isOpen() const { return !m_text.isEmpty(); }

    std::optional<UtcTime> first() const;
    std::optional<UtcTime> last() const;
    /// Groups of the first record; 0: there is none.
    qsizetype groups() const;
    /// Between two records, by the median of the first ones; a second when there are too few.
    std::chrono::microseconds period() const;

    /// Every record of from ≤ t < to, in order, until \a take returns false.
    using Take = std::function<bool(UtcTime, const HistoryRow &)>;
    void read(UtcTime from, UtcTime to, const Take &take) const;

private:
    QByteArrayView lineAt(qsizetype offset) const;
    qsizetype nextLine(qsizetype offset) const;
    std::optional<UtcTime> timeOf(const HistoryRow &row) const;
    std::optional<UtcTime> timeFrom(qsizetype offset) const;
    qsizetype firstAtOrAfter(UtcTime time) const;

    QFile m_file;
    QTimeZone m_zone;
    QByteArrayView m_text; ///< the mapped file
    mutable QDate m_day; ///< of the last conversion: a zone is slow to ask
    mutable int m_hour = -1;
    mutable UtcTime m_hourStart;
};

} // namespace gorizont
