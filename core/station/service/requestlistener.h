#pragma once

#include "core/protocol/ackmessages.h"
#include "core/values/timing.h"

#include <QList>

#include <functional>
#include <optional>

namespace gorizont::station {

/// Picks the requests to one station out of all that is said on a line: noise, requests to others and their answers, files whose
/// text looks like a request. Pure: time is given. One for each line or connection.
///
/// Frames that are meant for others are skipped whole when their block is good, so that what lies inside is never taken for a
/// request. The block of an answer can be told only from the question before it, which is remembered. What does not
/// come to its end is given up after a silence, or when it takes far longer than its bytes need: the station is not deaf then.
class RequestListener
{
public:
    /// Whether this station answers for an address.
    using IsOwn = std::function<bool(quint8 address)>;

    /// \a byteTime: how long one byte takes on the line.
    RequestListener(IsOwn isOwn, std::chrono::microseconds byteTime);

    /// The requests that are whole with \a bytes, in their order.
    QList<ack::Asked> hear(QByteArrayView bytes, SteadyTime now);

private:
    std::optional<qsizetype> blockLength(const ack::Header &header) const;
    std::optional<ack::Asked> take(QByteArrayView frame);
    void giveUpStale(SteadyTime now);

    IsOwn m_isOwn;
    std::chrono::microseconds m_byteTime;
    QByteArray m_heard; ///< what may still become a frame
    SteadyTime m_lastHeard{};
    SteadyTime m_frameBegan{};
    ack::Question m_question{0, 0, 0}; ///< the last data command on this line, to whomever; address 0: none
};

} // namespace gorizont::station
