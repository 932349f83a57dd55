#include "core/mqtt/publishingpace.h"

#include <algorithm>
#include <utility>

namespace gorizont {

PublishingPace::Verdict PublishingPace::judge(const Reading &reading)
{
    Sensor &sensor = m_sensors[reading.number];
    Verdict verdict;
    verdict.isNewState = std::exchange(sensor.status, reading.status) != reading.status;
    verdict.isSent = verdict.isNewState || (reading.isAnswer && isDue(sensor, reading.time));
    if (verdict.isSent) {
        sensor.sentAt = reading.time;
    }
    return verdict;
}

/// A tenth of the interval is forgiven: answers never come in exact steps, and an interval that equals the polling
/// period means every answer. A clock that was set back makes due.
bool PublishingPace::isDue(const Sensor &sensor, UtcTime time) const
{
    return !sensor.sentAt || time < *sensor.sentAt || time - *sensor.sentAt >= m_interval - m_interval / 10;
}

std::chrono::milliseconds ReconnectPause::next(double chance)
{
    const std::chrono::duration<double, std::milli> reduced = m_pause * (1 - chance / 2);
    m_pause = std::min(m_pause * 2, longest);
    return std::chrono::round<std::chrono::milliseconds>(reduced);
}

} // namespace gorizont
