#include "core/alarms/noticepace.h"

#include <algorithm>

namespace gorizont {

void NoticePace::add(const Alarm &alarm, SteadyTime now)
{
    const auto told = m_toldAt.find(faultOf(alarm));
    const SteadyTime allowedAt = told == m_toldAt.end() ? now : std::max(now, told->second + m_limits.repetition);
    m_waiting[faultOf(alarm)] = {alarm.id, allowedAt};
    expect(std::max(now + m_limits.gathering, allowedAt));
}

void NoticePace::expect(SteadyTime at)
{
    m_earliest = m_earliest ? std::min(*m_earliest, at) : at;
}

std::optional<SteadyTime> NoticePace::dueAt() const
{
    return m_earliest && m_lastAt ? std::max(*m_earliest, *m_lastAt + m_limits.distance) : m_earliest;
}

Alarms NoticePace::take(const Alarms &unacknowledged, SteadyTime now)
{
    Alarms taken;
    if (!m_earliest || now < *dueAt()) {
        return taken;
    }
    std::map<Fault, Waiting> waiting;
    waiting.swap(m_waiting);
    m_earliest.reset();
    for (const Alarm &alarm : unacknowledged) {
        const auto found = waiting.find(faultOf(alarm));
        if (found == waiting.end() || found->second.id != alarm.id) {
            continue;
        }
        if (found->second.allowedAt <= now) {
            taken.append(alarm);
            m_toldAt[faultOf(alarm)] = now;
        } else {
            m_waiting.insert(*found);
            expect(found->second.allowedAt);
        }
    }
    if (!taken.isEmpty()) {
        m_lastAt = now;
    }
    return taken;
}

} // namespace gorizont
