#pragma once

#include "core/devices/lvims/lvimssimulator.h"
#include "core/line/line.h"

namespace gorizont::test {

inline SensorConfig vimsSensor()
{
    SensorConfig sensor;
    sensor.number = 7;
    sensor.index = 1;
    sensor.isOn = true;
    sensor.type = SensorType::LVims;
    sensor.model = QStringLiteral("L-VIMS");
    sensor.name = QStringLiteral("Pump (L-VIMS)");
    return sensor;
}

/// A line whose other end is one simulated module that answers at once. Its clock goes on only while somebody waits, so that a
/// capture of seconds costs no real time.
class ModuleLine : public Line
{
public:
    explicit ModuleLine(const SensorConfig &sensor = vimsSensor())
        : Line(std::chrono::milliseconds(100))
        , m_simulator(sensor, 3)
    {
    }

    lvims::SimulatedModule &module() { return m_simulator.module(); }
    void advance(SimulatedDevice::Time time) { m_now += time; }
    void setSilent(bool isSilent) { m_isSilent = isSilent; }
    SimulatedDevice::Time elapsed() const { return std::chrono::duration_cast<SimulatedDevice::Time>(m_now - m_start); }

    Result<void> open() override { return {}; }
    void close() override { m_arrived.clear(); }
    bool isOpen() const override { return true; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds) override
    {
        const QByteArray answer = m_simulator.receive(bytes, elapsed());
        m_arrived += m_isSilent ? QByteArray() : answer;
        return {};
    }
    Result<QByteArray> readSome(std::chrono::microseconds timeout) override
    {
        if (m_arrived.isEmpty()) {
            m_now += timeout;
        }
        return std::exchange(m_arrived, {});
    }
    SteadyTime now() const override { return m_now; }
    void sleepUntil(SteadyTime time) override { m_now = std::max(m_now, time); }

private:
    lvims::Simulator m_simulator;
    QByteArray m_arrived;
    SteadyTime m_start{std::chrono::hours(1)};
    SteadyTime m_now{m_start};
    bool m_isSilent = false;
};

} // namespace gorizont::test
