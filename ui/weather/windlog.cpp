#include "ui/weather/windlog.h"

namespace gorizont {

WindLog::WindLog(const SensorRegistry &registry, QObject *parent)
    : QObject(parent)
{
    connect(&registry, &SensorRegistry::readingsChanged, this, &WindLog::take);
}

void WindLog::take(const Readings &batch)
{
    for (const Reading &reading : batch) {
        if (!reading.isAnswer || !reading.answeredAt || !reading.weather) {
            continue;
        }
        if (const auto sample = WindSample::of(*reading.weather)) {
            m_records[reading.number].add(*reading.answeredAt, *sample);
        }
    }
}

WindCounts WindLog::over(int number, std::chrono::minutes span, SteadyTime now) const
{
    const auto found = m_records.constFind(number);
    return found == m_records.constEnd() ? WindCounts() : found->over(span, now);
}

} // namespace gorizont
