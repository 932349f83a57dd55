#pragma once

#include "core/values/timing.h"

#include <QtGlobal>

#include <map>

namespace gorizont {

/// The kinds of files that can fail apart from each other.
enum class HistoryStream : quint8 { Data, Acceleration, Log, Samples, Weather };

/// Remembers which files cannot be written, so that the journal hears once when something stops being saved and once
/// when everything is saved again, and the disk is asked every few seconds only. Pure.
class WriteHealth
{
public:
    explicit WriteHealth(std::chrono::milliseconds retryInterval)
        : m_retryInterval(retryInterval)
    {
    }

    bool isGood() const { return m_retryAt.empty(); }
    bool mayTry(HistoryStream stream, SteadyTime now) const
    {
        const auto found = m_retryAt.find(stream);
        return found == m_retryAt.end() || now >= found->second;
    }

    /// True: everything was good until now.
    [[nodiscard]] bool failed(HistoryStream stream, SteadyTime now)
    {
        const bool wasGood = isGood();
        m_retryAt[stream] = now + m_retryInterval;
        return wasGood;
    }

    /// True: this was the last that had failed.
    [[nodiscard]] bool succeeded(HistoryStream stream) { return m_retryAt.erase(stream) > 0 && isGood(); }

private:
    std::chrono::milliseconds m_retryInterval;
    std::map<HistoryStream, SteadyTime> m_retryAt; ///< of what fails
};

} // namespace gorizont
