#include "core/alarms/alarmboard.h"

#include "core/values/statustext.h"

#include <algorithm>

namespace gorizont {

namespace {

bool fails(LineState state)
{
    return state == LineState::Off || state == LineState::OpenFailed || state == LineState::Lost;
}

bool isOfPort(StatusCode code)
{
    return code == StatusCode::PortOff || code == StatusCode::PortError;
}

} // namespace

AlarmBoard::AlarmBoard(const QList<LineConfig> &lines)
{
    for (const LineConfig &config : lines) {
        if (!config.isOn) {
            continue;
        }
        Line line{config};
        for (int i = 0; i < static_cast<int>(config.sensors.size()); ++i) {
            if (config.sensors.at(i).isOn) {
                m_sensors.insert(config.sensors.at(i).number, Sensor{config.index, i});
                ++line.watchedSensors;
            }
        }
        if (line.watchedSensors > 0) {
            m_lines.insert(config.index, line);
        }
    }
}

AlarmBoard::Change AlarmBoard::update(const QList<Reading> &batch)
{
    Change change;
    for (const Reading &reading : batch) {
        const auto sensor = m_sensors.find(reading.number);
        if (sensor == m_sensors.end()) {
            continue;
        }
        const StatusCode code = statusCode(reading.status);
        const bool saysNothing = isOfPort(code) || (code == StatusCode::Good && !reading.isAnswer);
        if (code != sensor->code && !saysNothing) {
            updateSensor(*sensor, reading, change);
        } else if (code != StatusCode::Good && code == sensor->code) {
            updateCause(*sensor, reading, change);
        }
    }
    return change;
}

void AlarmBoard::updateSensor(Sensor &sensor, const Reading &reading, Change &change)
{
    const StatusCode code = statusCode(reading.status);
    const Line &line = m_lines[sensor.port];
    if (line.state == LineState::Service) {
        return;
    }
    end(sensor.alarm, change);
    sensor.code = code;
    if (code == StatusCode::Good) {
        return;
    }
    const SensorConfig &config = line.config.sensors.at(sensor.position);
    Alarm alarm;
    alarm.port = sensor.port;
    alarm.number = config.number;
    alarm.code = code;
    alarm.title = sensorTitle(config, line.config);
    alarm.place = config.place;
    alarm.type = config.type;
    alarm.cause = causeText(reading);
    alarm.began = reading.time;
    raise(std::move(alarm), sensor.alarm, change);
}

void AlarmBoard::updateCause(const Sensor &sensor, const Reading &reading, Change &change)
{
    const auto standing = m_standing.find(sensor.alarm);
    const QString cause = causeText(reading);
    if (standing != m_standing.end() && standing->second.cause != cause) {
        standing->second.cause = cause;
        change.isAny = true;
    }
}

AlarmBoard::Change AlarmBoard::updateLine(int port, LineState state, UtcTime now)
{
    Change change;
    const auto line = m_lines.find(port);
    if (line == m_lines.end() || line->state == state) {
        return change;
    }
    line->state = state;
    if (!fails(state)) {
        end(line->alarm, change);
        return change;
    }
    const StatusCode code = state == LineState::Off ? StatusCode::PortOff : StatusCode::PortError;
    if (const auto standing = m_standing.find(line->alarm);
        standing != m_standing.end() && standing->second.code == code) {
        standing->second.line = state;
        change.isAny = true;
        return change;
    }
    end(line->alarm, change);
    endSensorsOf(*line, change);
    Alarm alarm;
    alarm.port = port;
    alarm.sensors = line->watchedSensors;
    alarm.code = code;
    alarm.line = state;
    alarm.title = line->config.title();
    alarm.place = line->config.name;
    alarm.began = now;
    raise(std::move(alarm), line->alarm, change);
    return change;
}

void AlarmBoard::endSensorsOf(const Line &line, Change &change)
{
    for (const SensorConfig &config : line.config.sensors) {
        if (const auto sensor = m_sensors.find(config.number);
            sensor != m_sensors.end() && sensor->port == line.config.index) {
            end(sensor->alarm, change);
            sensor->code = StatusCode::Good;
        }
    }
}

void AlarmBoard::raise(Alarm alarm, quint64 &slot, Change &change)
{
    alarm.id = ++m_lastId;
    slot = alarm.id;
    m_standing.emplace(alarm.id, alarm);
    change.raised.append(std::move(alarm));
    change.isAny = true;
}

void AlarmBoard::end(quint64 &slot, Change &change)
{
    if (slot != 0) {
        m_standing.erase(std::exchange(slot, 0));
        change.isAny = true;
    }
}

Alarms AlarmBoard::acknowledge(const QList<quint64> &ids)
{
    Alarms acknowledged;
    for (const quint64 id : ids) {
        const auto found = m_standing.find(id);
        if (found != m_standing.end() && !found->second.isAcknowledged) {
            found->second.isAcknowledged = true;
            acknowledged.append(found->second);
        }
    }
    return acknowledged;
}

Alarms AlarmBoard::unacknowledged() const
{
    Alarms list;
    for (const auto &[id, alarm] : m_standing) {
        if (!alarm.isAcknowledged) {
            list.append(alarm);
        }
    }
    return list;
}

int AlarmBoard::acknowledgedCount() const
{
    return static_cast<int>(std::count_if(m_standing.begin(), m_standing.end(), [](const auto &entry) {
        return entry.second.isAcknowledged;
    }));
}

} // namespace gorizont
