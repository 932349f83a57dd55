#pragma once

#include "core/values/timing.h"

#include <QDateTime>
#include <QTimeZone>

namespace gorizont::station {

/// The clock of a station: what the wall clock of its computer shows, counted in seconds since 1970 as if it were UTC
/// (spec/mk14.md, Frames, 4), and how far a dispatcher has set it away from that. Pure.
class StationClock
{
public:
    /// \a zone invalid: that of the computer.
    explicit StationClock(const QTimeZone &zone = {})
        : m_zone(zone)
    {
    }

    qint64 seconds(UtcTime now) const { return local(now) + m_offset; }

    /// From now on seconds() goes on from \a seconds.
    void set(qint64 seconds, UtcTime now) { m_offset = seconds - local(now); }

    qint64 offset() const { return m_offset; } ///< s, to the wall clock of the computer
    void setOffset(qint64 offset) { m_offset = offset; }

    /// The moment that the wall clock of the computer would have to show for \a seconds.
    UtcTime wallTime(qint64 seconds) const;

    /// \a seconds of the clock as date and time to be written.
    static QDateTime dateTime(qint64 seconds) { return QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC); }

private:
    qint64 local(UtcTime now) const;

    QTimeZone m_zone;
    qint64 m_offset = 0;
};

/// How far the clock was set, as it is kept in a file. Empty: that is no number.
std::optional<qint64> readClockOffset(const QByteArray &text);
QByteArray clockOffsetText(qint64 offset);

} // namespace gorizont::station
