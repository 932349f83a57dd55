#pragma once

#include "core/history/historyparser.h"
#include "core/values/timing.h"

#include <QFile>
#include <QTimeZone>

#include <functional>

namespace gorizont {

/// One text file of a month, read where it is wanted only: its records stand in ascending time. Any one thread. A medium
/// that goes away while it is read ends the file there.
class MonthRecords
{
public:
    MonthRecords(const QString &path, const QTimeZone &zone);

    bool isOpen() const { return m_size > 0; }

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
    QByteArrayView lineAt(qint64 offset) const;
    qint64 nextLine(qint64 offset) const;
    std::optional<UtcTime> timeOf(const HistoryRow &row) const;
    std::optional<UtcTime> timeFrom(qint64 offset) const;
    qint64 firstAtOrAfter(UtcTime time) const;

    mutable QFile m_file; // a mapped file would end the program when its medium is pulled
    QTimeZone m_zone;
    qint64 m_size = 0; ///< bytes
    mutable QByteArray m_piece; ///< of the file
    mutable qint64 m_pieceAt = 0;
    mutable QDate m_day; ///< of the last conversion: a zone is slow to ask
    mutable int m_hour = -1;
    mutable UtcTime m_hourStart;
};

} // namespace gorizont
