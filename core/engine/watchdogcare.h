#pragma once

#include "core/devices/driver.h"

#include <optional>

namespace gorizont {

/// When a line has to speak, and when to keep silent, for the sake of devices with a watchdog. Pure: time is given.
class WatchdogCare
{
public:
    /// A line is silenced at most once in so long, however many of its devices hang.
    static constexpr std::chrono::hours betweenSilences{1};

    explicit WatchdogCare(std::optional<KeepAlive> keepAlive)
        : m_keepAlive(std::move(keepAlive))
    {
    }

    /// Polling or service starts: what was said before is not known.
    void restart(SteadyTime now);
    /// The line has sent \a bytesSent in all: if that is more than before, something was said.
    void look(quint64 bytesSent, SteadyTime now);

    /// What has to be said now; empty: nothing.
    QByteArray due(SteadyTime now) const;
    /// When due() will have something. Empty: never.
    std::optional<SteadyTime> nextAt() const;

    /// From \a now on the line is silent for \a length. False: it was not long ago that it was.
    bool keepSilent(std::chrono::seconds length, SteadyTime now);
    bool isSilent(SteadyTime now) const { return m_silentUntil && now < *m_silentUntil; }
    SteadyTime silentUntil() const { return m_silentUntil.value_or(SteadyTime()); }

private:
    std::optional<KeepAlive> m_keepAlive;
    quint64 m_bytesSent = 0;
    SteadyTime m_spokenAt{};
    std::optional<SteadyTime> m_silencedAt;
    std::optional<SteadyTime> m_silentUntil;
};

} // namespace gorizont
