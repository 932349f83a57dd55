#include "core/station/sources/windpulses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gorizont::station {

namespace {

constexpr double fullCircle = 360; ///< degrees
constexpr double fullTurn = 2 * std::numbers::pi;

double seconds(WindPulses::Time time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

/// Whether the pulse at \a at follows \a last too soon; else it becomes the last one.
bool WindPulses::isDisturbance(std::optional<Time> &last, Time at) const
{
    if (last && at - *last < m_settings.shortest) {
        return true;
    }
    last = at;
    return false;
}

void WindPulses::addReference(Time at)
{
    const auto before = m_lastReference;
    if (isDisturbance(m_lastReference, at)) {
        return;
    }
    m_period = before ? std::optional(at - *before) : std::nullopt;
    m_reference.push_back(at);
    forget(at - m_settings.averaging);
}

/// A main pulse belongs to the reference pulse before it, and turns within the period that ended there.
void WindPulses::addMain(Time at)
{
    if (isDisturbance(m_lastMain, at) || !m_period || m_period->count() <= 0) {
        return;
    }
    const double turns = seconds(at - *m_lastReference) / seconds(*m_period);
    if (turns < 2) { // the reference has stopped: there is nothing to compare with
        m_phases.push_back({at, turns - std::floor(turns)});
    }
}

/// One pulse before the interval stays: the first period of the interval began there.
void WindPulses::forget(Time before)
{
    while (m_reference.size() > 1 && m_reference[1] < before) {
        m_reference.pop_front();
    }
    while (!m_phases.empty() && m_phases.front().at < before) {
        m_phases.pop_front();
    }
}

WindRaw WindPulses::measure(Time now)
{
    const Time begin = now - m_settings.averaging;
    forget(begin);
    WindRaw raw;
    raw.frequency = 0;
    if (m_reference.size() > 1 && m_reference.back() >= begin) {
        // The pulse before the interval counts only where it is needed: before it there may have been a calm.
        const std::size_t first = m_reference.size() > 2 && m_reference.front() < begin ? 1 : 0;
        const auto periods = static_cast<double>(m_reference.size() - 1 - first);
        raw.frequency = rounded(periods / seconds(m_reference.back() - m_reference[first]));
    }
    if (!m_phases.empty()) {
        double sine = 0;
        double cosine = 0;
        for (const Phase &phase : m_phases) {
            sine += std::sin(phase.turn * fullTurn);
            cosine += std::cos(phase.turn * fullTurn);
        }
        const double angle = std::atan2(sine, cosine) / fullTurn * fullCircle;
        raw.phase = std::fmod(rounded(angle < 0 ? angle + fullCircle : angle), fullCircle);
    }
    return raw;
}

double WindPulses::rounded(double value) const
{
    return std::round(value * m_settings.multiplier) / m_settings.multiplier;
}

} // namespace gorizont::station
