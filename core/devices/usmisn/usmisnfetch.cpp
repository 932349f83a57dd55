#include "core/devices/usmisn/usmisnfetch.h"

namespace gorizont::usmisn {

RecordFetch::RecordFetch(RecordMask mask, const QList<int> &channels)
    : m_channels(channels)
    , m_wanted(mask)
{
}

void RecordFetch::record(const Result<void> &transfer)
{
    if (transfer) {
        m_channels.removeFirst();
        m_attempt = 0;
    } else if (!isWorthAnother(transfer.fault()) || ++m_attempt == mostAttempts) {
        m_result = transfer;
        m_channels.clear();
    }
}

} // namespace gorizont::usmisn
