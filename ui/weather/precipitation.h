#pragma once

#include "core/values/weather.h"

#include <QDateTime>

#include <optional>

namespace gorizont {

/// A time during which it rained, by the clock of the station. At least one of the ends is known.
struct Precipitation
{
    std::optional<qint64> begin; ///< seconds since 1970; empty: before what the station remembers
    std::optional<qint64> end; ///< likewise; empty: it goes on, or nobody noticed the end
    bool isGoingOn = false; ///< the newest event is its begin
    bool operator==(const Precipitation &) const = default;
};

namespace precipitation {

/// Pairs what \a events, newest first, tell; newest first. Of two begins without an end between them the first one stands alone.
QList<Precipitation> spells(const QList<PrecipitationEvent> &events);

/// Which time the clock of a station shows (spec/mk14.md, "Frames", 4).
enum class StationClock : quint8 { Local, Utc };

/// What a wall clock beside this computer showed at \a seconds of the station.
QDateTime localTime(qint64 seconds, StationClock clock);
/// Seconds since 1970 as the station would count \a now.
qint64 stationTime(const QDateTime &now, StationClock clock);

} // namespace precipitation

} // namespace gorizont
