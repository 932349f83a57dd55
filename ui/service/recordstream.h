#pragma once

#include "core/devices/usmisn/usmisnvalues.h"

#include <QList>
#include <QMutex>

#include <utility>

namespace gorizont {

/// Records on their way from the thread of the line to that of the windows. Thread-safe.
class RecordStream
{
public:
    /// False: nobody wants more.
    bool put(const usmisn::Value &record)
    {
        const QMutexLocker lock(&m_mutex);
        if (!m_isStopped) {
            m_records.append(record);
        }
        return !m_isStopped;
    }
    QList<usmisn::Value> take()
    {
        const QMutexLocker lock(&m_mutex);
        return std::exchange(m_records, {});
    }
    void stop()
    {
        const QMutexLocker lock(&m_mutex);
        m_isStopped = true;
    }

private:
    QMutex m_mutex; ///< guards the rest
    QList<usmisn::Value> m_records;
    bool m_isStopped = false;
};

} // namespace gorizont
