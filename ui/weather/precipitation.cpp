#include "ui/weather/precipitation.h"

#include <algorithm>

namespace gorizont::precipitation {

QList<Precipitation> spells(const QList<PrecipitationEvent> &events)
{
    QList<Precipitation> list; // oldest first
    bool isOpen = false;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        if (event->isStart) {
            list += Precipitation{event->time, {}, false};
        } else if (isOpen) {
            list.last().end = event->time;
        } else {
            list += Precipitation{{}, event->time, false};
        }
        isOpen = event->isStart;
    }
    if (isOpen) {
        list.last().isGoingOn = true;
    }
    std::ranges::reverse(list);
    return list;
}

/// A station with local time counts the seconds as if its own zone were UTC: what it says is read as a wall clock.
QDateTime localTime(qint64 seconds, StationClock clock)
{
    if (clock == StationClock::Utc) {
        return QDateTime::fromSecsSinceEpoch(seconds);
    }
    const QDateTime wall = QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC);
    return QDateTime(wall.date(), wall.time());
}

qint64 stationTime(const QDateTime &now, StationClock clock)
{
    return clock == StationClock::Utc ? now.toSecsSinceEpoch()
                                      : now.toSecsSinceEpoch() + now.toLocalTime().offsetFromUtc();
}

} // namespace gorizont::precipitation
