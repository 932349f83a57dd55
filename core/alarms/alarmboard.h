#pragma once

#include "core/alarms/alarm.h"

#include <QHash>

#include <map>

namespace gorizont {

/// What stands before the dispatcher. Pure: it is told what happens, and when. The rules:
///
/// - A sensor that enters a critical code raises an alarm; another critical code takes its place as a new alarm, not
///   acknowledged; only a good answer ends it. "No answer yet" says nothing: it neither raises nor ends.
/// - Codes 1 and 2 are those of a port. One alarm stands for all sensors of the port, as long as the line fails; another
///   way of failing is the same alarm. It takes the place of what its sensors had raised.
/// - Of a vibration module without a sensor that works, the alarm says which lines are shorted or broken by now.
/// - Sensors and ports that the ini switches off are not watched, nor is a port without sensors that are on.
/// - While a port is in service mode its sensors raise nothing and end nothing.
class AlarmBoard
{
public:
    struct Change
    {
        Alarms raised;
        bool isAny = false; ///< something was raised, has ended or reads differently
    };

    explicit AlarmBoard(const QList<LineConfig> &lines);

    Change update(const QList<Reading> &batch);
    Change updateLine(int port, LineState state, UtcTime now);

    /// Those of \a ids that stand and were not acknowledged yet are from now on; returns them.
    Alarms acknowledge(const QList<quint64> &ids);

    /// What stands and nobody has acknowledged, the oldest first.
    Alarms unacknowledged() const;
    /// How many alarms are acknowledged and stand all the same.
    int acknowledgedCount() const;

private:
    struct Line
    {
        LineConfig config;
        int watchedSensors = 0;
        LineState state = LineState::Opening;
        quint64 alarm = 0; ///< 0: none stands
    };
    /// Small, because every reading looks one up.
    struct Sensor
    {
        int port = 0; ///< LineConfig::index
        int position = 0; ///< in LineConfig::sensors
        StatusCode code = StatusCode::Good; ///< of the alarm that stands; Good: none
        quint64 alarm = 0; ///< 0: none stands
    };

    void updateSensor(Sensor &sensor, const Reading &reading, Change &change);
    void updateCause(const Sensor &sensor, const Reading &reading, Change &change);
    void raise(Alarm alarm, quint64 &slot, Change &change);
    void end(quint64 &slot, Change &change);
    void endSensorsOf(const Line &line, Change &change);

    QHash<int, Line> m_lines; ///< by LineConfig::index
    QHash<int, Sensor> m_sensors; ///< by N
    std::map<quint64, Alarm> m_standing;
    quint64 m_lastId = 0;
};

} // namespace gorizont
