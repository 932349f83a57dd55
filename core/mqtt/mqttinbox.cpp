#include "core/mqtt/mqttinbox.h"

#include <QMutexLocker>

#include <utility>

namespace gorizont {

bool MqttInbox::put(const Readings &batch)
{
    const QMutexLocker lock(&m_mutex);
    Readings &readings = m_contents.readings;
    readings += batch;
    if (const qsizetype excess = readings.size() - m_mostReadings; excess > 0) {
        readings.remove(0, excess);
        m_contents.readingsDropped += static_cast<quint64>(excess);
    }
    return !std::exchange(m_isWoken, true);
}

bool MqttInbox::put(const LineStatus &status)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.lines.insert(status.port, status);
    return !std::exchange(m_isWoken, true);
}

MqttInbox::Contents MqttInbox::take()
{
    const QMutexLocker lock(&m_mutex);
    m_isWoken = false;
    return std::exchange(m_contents, {});
}

} // namespace gorizont
