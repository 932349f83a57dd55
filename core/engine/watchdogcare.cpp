#include "core/engine/watchdogcare.h"

namespace gorizont {

/// A silence that was not over is given up.
void WatchdogCare::restart(SteadyTime now)
{
    m_spokenAt = now;
    m_silentUntil.reset();
}

void WatchdogCare::look(quint64 bytesSent, SteadyTime now)
{
    if (bytesSent != m_bytesSent) {
        m_bytesSent = bytesSent;
        m_spokenAt = now;
    }
}

QByteArray WatchdogCare::due(SteadyTime now) const
{
    const auto next = nextAt();
    return next && now >= *next ? m_keepAlive->message : QByteArray();
}

std::optional<SteadyTime> WatchdogCare::nextAt() const
{
    if (!m_keepAlive) {
        return std::nullopt;
    }
    const SteadyTime spokenEnough = m_spokenAt + m_keepAlive->after;
    return m_silentUntil ? std::max(spokenEnough, *m_silentUntil) : spokenEnough;
}

bool WatchdogCare::keepSilent(std::chrono::seconds length, SteadyTime now)
{
    if (m_silencedAt && now - *m_silencedAt < betweenSilences) {
        return false;
    }
    m_silencedAt = now;
    m_silentUntil = now + length;
    return true;
}

} // namespace gorizont
