#pragma once

#include "core/devices/attempts.h"
#include "core/devices/usmisn/usmisnvalues.h"

#include <QList>

namespace gorizont::usmisn {

/// Which transfers bring the records of a device: one a channel, and one more with All after each that broke off, because
/// New does not send a record twice. Pure.
class RecordFetch
{
public:
    explicit RecordFetch(RecordMask mask, const QList<int> &channels = {channelX, channelY});

    bool isOver() const { return m_channels.isEmpty(); }
    int channel() const { return m_channels.constFirst(); } ///< of the transfer that is due
    RecordMask mask() const { return m_attempt == 0 ? m_wanted : RecordMask::All; } ///< likewise
    bool isAgain() const { return m_attempt > 0; } ///< likewise: what it brings is known in part

    /// What became of the transfer that was due.
    void record(const Result<void> &transfer);

    /// After the end. A fault: something may be missing that only All brings.
    const Result<void> &result() const { return m_result; }

private:
    QList<int> m_channels; ///< not done yet
    RecordMask m_wanted;
    int m_attempt = 0;
    Result<void> m_result;
};

} // namespace gorizont::usmisn
