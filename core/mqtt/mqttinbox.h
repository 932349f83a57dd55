#pragma once

#include "core/values/linestatus.h"
#include "core/values/reading.h"

#include <QHash>
#include <QMutex>

namespace gorizont {

/// What other threads left for the broker. A broker, a name server or a disk that hangs must not eat the memory: only
/// the newest readings up to a limit are kept, and the last state of each port. Thread-safe.
class MqttInbox
{
public:
    struct Contents
    {
        Readings readings; ///< in the order of arrival
        QHash<int, LineStatus> lines; ///< port → the last one
        quint64 readingsDropped = 0; ///< the oldest
    };

    explicit MqttInbox(qsizetype mostReadings)
        : m_mostReadings(mostReadings)
    {
    }

    /// True: the publisher has to be woken, nobody did since it last took the contents.
    [[nodiscard]] bool put(const Readings &batch);
    [[nodiscard]] bool put(const LineStatus &status);

    /// Everything; the inbox is empty then.
    Contents take();

private:
    const qsizetype m_mostReadings;
    QMutex m_mutex;
    Contents m_contents;
    bool m_isWoken = false;
};

} // namespace gorizont
