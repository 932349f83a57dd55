#pragma once

#include "core/values/lineconfig.h"
#include "core/values/reading.h"

namespace gorizont::test {

inline SensorConfig alarmSensor(int port, int index, int number, bool isOn = true)
{
    SensorConfig sensor;
    sensor.port = port;
    sensor.index = index;
    sensor.number = number;
    sensor.address = 10 + index;
    sensor.isOn = isOn;
    sensor.type = SensorType::InD;
    sensor.model = QStringLiteral("IN-D3");
    sensor.place = QStringLiteral("Floor %1").arg(number);
    sensor.measuresTilt = true;
    return sensor;
}

inline LineConfig alarmLine(int index, bool isOn, const QList<SensorConfig> &sensors)
{
    LineConfig line;
    line.index = index;
    line.com = 10 * index;
    line.name = QStringLiteral("Adapter %1").arg(index);
    line.isOn = isOn;
    line.sensors = sensors;
    return line;
}

/// COM10 with N 1, N 2 and N 3, which is off; COM20 with N 4; COM30, off, with N 5; COM40 with N 6, which is off.
inline QList<LineConfig> alarmLines()
{
    return {
        alarmLine(1, true, {alarmSensor(1, 1, 1), alarmSensor(1, 2, 2), alarmSensor(1, 3, 3, false)}),
        alarmLine(2, true, {alarmSensor(2, 1, 4)}),
        alarmLine(3, false, {alarmSensor(3, 1, 5)}),
        alarmLine(4, true, {alarmSensor(4, 1, 6, false)}),
    };
}

inline UtcTime second(int seconds)
{
    return UtcTime(std::chrono::hours(400000) + std::chrono::seconds(seconds));
}

/// What the engine says after a turn: the sensor answered, or it did not.
inline Reading turn(int number, int status, bool isAnswer, int at = 0)
{
    Reading reading;
    reading.number = number;
    reading.status = static_cast<quint16>(status);
    reading.isAnswer = isAnswer;
    reading.time = second(at);
    return reading;
}

} // namespace gorizont::test
