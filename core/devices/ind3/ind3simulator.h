#pragma once

#include "core/devices/ind3/ind3simulatorports.h"
#include "core/devices/simulateddevice.h"
#include "core/values/sensorconfig.h"

#include <memory>

namespace gorizont::ind3 {

/// An ИН-Д3 on a simulated line: tilts with the building of \a seed and keeps its settings, also over a reboot.
/// Where the documents are silent, it does not answer what it does not understand.
class Simulator : public SimulatedDevice
{
public:
    Simulator(const SensorConfig &sensor, quint64 seed);

    QByteArray receive(QByteArrayView bytes, Time now) override;
    void reboot(Time now) override;

    /// What the device answers to the question for its version: 0 good, 0x10…0x12 errors (spec/ind3.md).
    void setSelfTest(quint8 code) { m_sensor.selfTest = code; }

    const SimulatedSensor &sensor() const { return m_sensor; }

private:
    QByteArray hear(char byte, Time now);

    SimulatedSensor m_sensor;
    Port211 m_port211;
    Port210 m_port210;
    PortModbus m_portModbus;
};

/// Speaks the protocol that the option `protocol` of \a sensor names.
std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::ind3
