#include "core/station/service/stationclock.h"

namespace gorizont::station {

qint64 StationClock::local(UtcTime now) const
{
    const auto seconds = std::chrono::floor<std::chrono::seconds>(now).time_since_epoch().count();
    QDateTime time = QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC);
    time = m_zone.isValid() ? time.toTimeZone(m_zone) : time.toLocalTime();
    return seconds + time.offsetFromUtc();
}

UtcTime StationClock::wallTime(qint64 seconds) const
{
    const QDateTime shown = dateTime(seconds);
    const QDateTime local = m_zone.isValid() ? QDateTime(shown.date(), shown.time(), m_zone)
                                             : QDateTime(shown.date(), shown.time(), Qt::LocalTime);
    return UtcTime(std::chrono::seconds(local.toSecsSinceEpoch()));
}

std::optional<qint64> readClockOffset(const QByteArray &text)
{
    bool isNumber = false;
    const qint64 offset = text.trimmed().toLongLong(&isNumber);
    return isNumber ? std::optional(offset) : std::nullopt;
}

QByteArray clockOffsetText(qint64 offset)
{
    return QByteArray::number(offset) + '\n';
}

} // namespace gorizont::station
