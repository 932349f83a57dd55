#include "core/registry/sensorregistry.h"

#include <algorithm>

namespace gorizont {

SensorRegistry::SensorRegistry(const QList<LineConfig> &lines, const StatusRules &rules, QObject *parent)
    : QObject(parent)
{
    for (const LineConfig &line : lines) {
        const int lineIndex = static_cast<int>(m_lines.size());
        LineStatus status;
        status.port = line.index;
        status.state = line.isOn ? LineState::Opening : LineState::Off;
        m_lines.push_back({line, status, {}});
        m_indexOfPort.insert(line.index, lineIndex);
        for (const SensorConfig &sensor : line.sensors) {
            Sensor entry{sensor, lineIndex, {}, 0, {}};
            entry.information.number = sensor.number;
            entry.reading.number = sensor.number;
            entry.reading.time = utcNow();
            entry.reading.status = initialSensorWord(line, sensor, rules);
            m_sensors.push_back(entry);
        }
    }
    std::stable_sort(m_sensors.begin(), m_sensors.end(), [](const Sensor &a, const Sensor &b) {
        return a.config.number < b.config.number;
    });
    for (int i = 0; i < static_cast<int>(m_sensors.size()); ++i) {
        const Sensor &sensor = m_sensors[static_cast<std::size_t>(i)];
        m_indexOfNumber.insert(sensor.config.number, i);
        m_lines[static_cast<std::size_t>(sensor.line)].sensors.push_back(i);
    }
    for (Line &line : m_lines) {
        std::sort(line.sensors.begin(), line.sensors.end(), [this](int a, int b) {
            return m_sensors[static_cast<std::size_t>(a)].config.index
                < m_sensors[static_cast<std::size_t>(b)].config.index;
        });
    }
}

Readings SensorRegistry::readings() const
{
    Readings all;
    all.reserve(static_cast<qsizetype>(m_sensors.size()));
    for (const Sensor &sensor : m_sensors) {
        all.append(sensor.reading);
    }
    return all;
}

QList<LineStatus> SensorRegistry::lineStatuses() const
{
    QList<LineStatus> all;
    for (const Line &line : m_lines) {
        all.append(line.status);
    }
    return all;
}

void SensorRegistry::update(const QList<Reading> &batch)
{
    for (const Reading &reading : batch) {
        if (const int index = indexOf(reading.number); index >= 0) {
            m_sensors[static_cast<std::size_t>(index)].reading = reading;
        }
    }
    Q_EMIT readingsChanged(batch);
}

void SensorRegistry::updateLine(const LineStatus &status)
{
    if (const int index = lineIndexOf(status.port); index >= 0) {
        m_lines[static_cast<std::size_t>(index)].status = status;
        Q_EMIT lineChanged(status);
    }
}

void SensorRegistry::addBlock(const SampleBlock &block)
{
    Q_EMIT blockAdded(block);
}

void SensorRegistry::setPacketsSaved(int number, quint64 packets)
{
    if (const int index = indexOf(number); index >= 0) {
        m_sensors[static_cast<std::size_t>(index)].packetsSaved = packets;
    }
}

void SensorRegistry::setInformation(const DeviceInformation &information)
{
    if (const int index = indexOf(information.number); index >= 0) {
        m_sensors[static_cast<std::size_t>(index)].information = information;
    }
}

} // namespace gorizont
