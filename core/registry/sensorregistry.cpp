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
    if (m_chains.isEmpty()) {
        Q_EMIT readingsChanged(batch);
        return;
    }
    Readings placed = batch;
    for (Reading &reading : placed) {
        if (m_chainOfNumber.contains(reading.number)) {
            reading.displacement = displacementOf(reading.number);
            m_sensors[static_cast<std::size_t>(indexOf(reading.number))].reading.displacement = reading.displacement;
        }
    }
    Q_EMIT readingsChanged(placed);
}

void SensorRegistry::setChains(const QList<ChainConfig> &chains)
{
    m_chains = chains;
    m_chainOfNumber.clear();
    for (qsizetype i = 0; i < chains.size(); ++i) {
        for (const ChainLink &link : chains.at(i).links) {
            if (indexOf(link.number) >= 0) {
                m_chainOfNumber.insert(link.number, i);
            }
        }
    }
}

std::optional<Tilt> SensorRegistry::tiltOf(int number) const
{
    const int index = indexOf(number);
    if (index < 0) {
        return {};
    }
    const Reading &reading = m_sensors[static_cast<std::size_t>(index)].reading;
    return isTiltValid(reading.status) ? reading.tilt : std::nullopt;
}

std::vector<ChainNode> SensorRegistry::nodesOf(const ChainConfig &chain) const
{
    return chainNodes(chain, [this](int number) { return tiltOf(number); });
}

std::optional<LinkDisplacement> SensorRegistry::displacementOf(int number) const
{
    const std::vector<ChainNode> nodes = nodesOf(m_chains.at(m_chainOfNumber.value(number)));
    const auto node =
        std::find_if(nodes.begin(), nodes.end(), [number](const ChainNode &n) { return n.number == number; });
    if (node == nodes.end() || !node->own) {
        return {};
    }
    return LinkDisplacement{*node->own, node->sum};
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

void SensorRegistry::addCapture(const SignalCapture &captured)
{
    Q_EMIT captureAdded(captured);
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
