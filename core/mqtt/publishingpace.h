#pragma once

#include "core/values/reading.h"

#include <QHash>

namespace gorizont {

/// Decides which readings of a sensor are sent: each answer, or one an interval, and each change of the status word.
/// Pure.
class PublishingPace
{
public:
    /// \a interval 0: every answer.
    explicit PublishingPace(std::chrono::milliseconds interval)
        : m_interval(interval)
    {
    }

    /// What the sensor's word is before its first reading.
    void begin(int number, quint16 status) { m_sensors[number].status = status; }

    struct Verdict
    {
        bool isSent = false;
        bool isNewState = false; ///< the status word changed
    };
    Verdict judge(const Reading &reading);

private:
    struct Sensor
    {
        quint16 status = 0;
        std::optional<UtcTime> sentAt;
    };

    bool isDue(const Sensor &sensor, UtcTime time) const;

    std::chrono::milliseconds m_interval;
    QHash<int, Sensor> m_sensors;
};

/// The pause before the next attempt to reach the broker: it doubles from a second to a minute, and chance takes up to
/// half of it, so that many sites do not come back at the same moment. Pure.
class ReconnectPause
{
public:
    static constexpr std::chrono::milliseconds shortest{1000};
    static constexpr std::chrono::milliseconds longest{60000};

    /// \a chance: 0 ≤ chance < 1.
    std::chrono::milliseconds next(double chance);
    void reset() { m_pause = shortest; }

private:
    std::chrono::milliseconds m_pause = shortest;
};

} // namespace gorizont
