#pragma once

#include "core/devices/driver.h"
#include "core/engine/accelwindow.h"
#include "core/engine/sensorhealth.h"
#include "core/values/geometry.h"
#include "core/values/statusword.h"

#include <memory>

namespace gorizont {

/// One sensor of a line in the thread of the line: its driver, its health, the accelerations of its last minute, and
/// the reading that the rest of the program sees. Here a measurement becomes a reading: axes, offsets, status word.
class PolledSensor
{
public:
    PolledSensor(std::unique_ptr<Driver> driver, const StatusRules &rules);

    const SensorConfig &config() const { return m_driver->settings().sensor; }
    const Reading &reading() const { return m_reading; }
    Driver &driver() { return *m_driver; }

    bool isDue(SteadyTime now) const { return m_health.isDue(now); }
    void probeSoon() { m_health.probeSoon(); }

    /// One turn. The reading is new afterwards, whatever the result. Closed and Cancelled are the line's fault and are not
    /// held against the sensor.
    Result<void> poll(Line &line);

    bool hasBacklog() const { return m_driver->hasBacklog(); }
    /// How long the last step of bulk data took.
    std::chrono::microseconds fetchTime() const { return m_fetchTime; }
    /// One step of bulk data. A fault counts like a failed turn.
    Result<QList<SampleBlock>> fetch(Line &line);

    /// The line went into \a state: the word of the sensor follows, its values stay.
    void lineBecame(LineState state);
    /// Polling starts again after the line was opened or service ended.
    void restart();

private:
    void take(const Measurement &measurement, SteadyTime now);
    void countFailure(Fault fault, SteadyTime now);
    void updateStatus();
    void updateAcceleration(SteadyTime now);

    std::unique_ptr<Driver> m_driver;
    StatusRules m_rules;
    AxisTransform m_transform;
    SensorHealth m_health;
    AccelWindow m_window;
    std::optional<SteadyTime> m_lastBlockAt;
    SensorSituation m_situation;
    Reading m_reading;
    std::optional<SteadyTime> m_turnAt;
    std::chrono::microseconds m_fetchTime{0};
};

} // namespace gorizont
