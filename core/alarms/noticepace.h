#pragma once

#include "core/alarms/alarm.h"

#include <map>
#include <optional>
#include <tuple>

namespace gorizont {

/// When the desktop tells the dispatcher, so that a loose cable does not bury him in notifications: the first alarm waits
/// a moment for those that belong to it, then everything goes together, and the next notification keeps its distance.
/// A fault that comes and goes is told again only after a while, if it stands then; list, banner and journal show it at
/// once. Pure.
class NoticePace
{
public:
    struct Limits
    {
        std::chrono::milliseconds gathering{2000}; ///< from the first alarm to the notification
        std::chrono::milliseconds distance{10000}; ///< between two notifications, at least
        std::chrono::milliseconds repetition{300000}; ///< before the same fault is told again, at least
    };

    explicit NoticePace(const Limits &limits)
        : m_limits(limits)
    {
    }

    void add(const Alarm &alarm, SteadyTime now);

    /// When to take() what waits; empty: nothing does.
    std::optional<SteadyTime> dueAt() const;

    /// Once it is due: the alarms that wait and may be told. Those that are not in \a unacknowledged any more are forgotten.
    Alarms take(const Alarms &unacknowledged, SteadyTime now);

private:
    using Fault = std::tuple<int, int, StatusCode>; ///< port, number, code
    struct Waiting
    {
        quint64 id = 0; ///< of the newest alarm about this fault
        SteadyTime allowedAt; ///< not told earlier
    };

    static Fault faultOf(const Alarm &alarm) { return {alarm.port, alarm.number, alarm.code}; }
    void expect(SteadyTime at);

    Limits m_limits;
    std::map<Fault, Waiting> m_waiting;
    std::map<Fault, SteadyTime> m_toldAt;
    std::optional<SteadyTime> m_earliest; ///< when the first of those that wait is ready
    std::optional<SteadyTime> m_lastAt; ///< of a notification
};

} // namespace gorizont
