#include "core/opc/opcimage.h"

namespace gorizont {

OpcImage::OpcImage(const QList<LineConfig> &lines, const QList<OpcTag> &tags, UtcTime start)
    : m_tags(tags)
{
    OpcSample initial;
    initial.time = start;
    m_samples.assign(static_cast<std::size_t>(tags.size()), initial);
    for (const LineConfig &line : lines) {
        LineStatus status;
        status.port = line.index;
        status.state = line.isOn ? LineState::Opening : LineState::Off;
        m_lines.insert(line.index, status);
        for (const SensorConfig &config : line.sensors) {
            Sensor sensor;
            sensor.config = config;
            sensor.reading.number = config.number;
            m_sensors.insert(config.number, sensor);
        }
    }
    for (int index = 0; index < static_cast<int>(tags.size()); ++index) {
        m_sensors[tags.at(index).number].tags.push_back(index);
    }
    std::vector<int> all;
    for (Sensor &sensor : m_sensors) {
        refresh(sensor, start, all);
    }
}

void OpcImage::update(const Reading &reading, std::vector<int> &changed)
{
    const auto sensor = m_sensors.find(reading.number);
    if (sensor != m_sensors.end()) {
        sensor->reading = reading;
        refresh(*sensor, reading.time, changed);
        sensor->reading.isAnswer = false; // a state of the line later on is no answer
    }
}

void OpcImage::update(const LineStatus &status, UtcTime now, std::vector<int> &changed)
{
    const auto line = m_lines.find(status.port);
    if (line == m_lines.end()) {
        return;
    }
    const bool isNews = line->state != status.state || line->openedAt != status.openedAt;
    *line = status;
    if (!isNews) {
        return; // counters
    }
    for (Sensor &sensor : m_sensors) {
        if (sensor.config.port == status.port) {
            refresh(sensor, now, changed);
        }
    }
}

void OpcImage::refresh(Sensor &sensor, UtcTime time, std::vector<int> &changed)
{
    const OpcQuality overall = opcQuality(sensor.config, m_lines.value(sensor.config.port), sensor.reading);
    for (const int index : sensor.tags) {
        OpcSample &sample = m_samples[static_cast<std::size_t>(index)];
        const OpcSample next = opcNext(sample, overall, m_tags.at(index).read(sensor.reading), sensor.reading, time);
        if (next != sample) {
            sample = next;
            changed.push_back(index);
        }
    }
}

} // namespace gorizont
