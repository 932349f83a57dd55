#pragma once

#include "core/devices/lvims/lvimssimulatedmodule.h"
#include "core/devices/simulateddevice.h"
#include "core/values/sensorconfig.h"

#include <memory>

namespace gorizont::lvims {

/// A module behind a line: takes the requests to its unit out of what it hears and answers them. Several clients give it whole
/// requests in turns.
class Simulator : public SimulatedDevice
{
public:
    Simulator(const SensorConfig &sensor, quint64 seed);

    QByteArray receive(QByteArrayView bytes, Time now) override;
    void reboot(Time now) override;
    bool takeDisconnect() override { return m_module.takeRestart(); }

    SimulatedModule &module() { return m_module; }

private:
    int m_unit;
    SimulatedModule m_module;
    QByteArray m_heard;
};

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::lvims
