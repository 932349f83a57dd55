#pragma once

#include "core/values/weather.h"

namespace gorizont::station {

/// When it began and ended to rain, by the sensor of liquid precipitation (manual 004, section 4.2, command 8).
class PrecipitationWatch
{
public:
    static constexpr qsizetype mostEvents = 10;

    /// \a isWet at \a clock, in seconds since 1970 by the clock of the station. The first call makes an event only when it is wet.
    void update(bool isWet, qint64 clock);
    /// The ten newest, newest first.
    const QList<PrecipitationEvent> &events() const { return m_events; }

private:
    bool m_isWet = false;
    QList<PrecipitationEvent> m_events;
};

} // namespace gorizont::station
