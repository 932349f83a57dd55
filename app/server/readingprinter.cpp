#include "app/server/readingprinter.h"

#include "core/values/readingjson.h"

#include <cstdio>

namespace gorizont {

ReadingPrinter::ReadingPrinter(const SensorRegistry &registry)
{
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        LineConfig line = registry.lines()[static_cast<std::size_t>(sensor.line)].config;
        line.sensors.clear();
        m_known.insert(sensor.config.number, {sensor.config, line, sensor.reading.status});
    }
}

void ReadingPrinter::offer(const Readings &batch)
{
    if (m_isClosed || m_waiting >= longestQueue) {
        return;
    }
    ++m_waiting;
    QMetaObject::invokeMethod(
        this, [this, batch] { print(batch); }, Qt::QueuedConnection);
}

void ReadingPrinter::print(const Readings &batch)
{
    --m_waiting;
    for (const Reading &reading : batch) {
        const auto known = m_known.find(reading.number);
        if (known == m_known.end() || (!reading.isAnswer && reading.status == known->status)) {
            continue;
        }
        known->status = reading.status;
        const QByteArray line = readingToJson(reading, known->config, known->line) + '\n';
        if (std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stdout)
            != static_cast<std::size_t>(line.size())) {
            m_isClosed = true;
            return;
        }
    }
    if (std::fflush(stdout) != 0) {
        m_isClosed = true;
    }
}

} // namespace gorizont
