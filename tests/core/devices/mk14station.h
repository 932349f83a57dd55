#pragma once

#include "core/devices/mk14/mk14service.h"
#include "core/devices/mk14/mk14simulator.h"
#include "core/line/line.h"

namespace gorizont::test {

inline SensorConfig weatherStation(int address = 1)
{
    SensorConfig sensor;
    sensor.number = 7;
    sensor.index = 1;
    sensor.address = address;
    sensor.isOn = true;
    sensor.type = SensorType::Mk14;
    sensor.model = QStringLiteral("MK-14");
    sensor.name = QStringLiteral("МК-14");
    sensor.measuresWeather = true;
    sensor.measuresTemperature = true;
    return sensor;
}

constexpr qint64 startOfClock = 1'700'000'000; ///< seconds since 1970

/// A line whose other end is one simulated station that answers at once; time goes on only while somebody waits.
class StationLine : public Line
{
public:
    explicit StationLine(const SensorConfig &sensor = weatherStation())
        : Line(std::chrono::milliseconds(100))
        , m_simulator(sensor, 3, startOfClock)
    {
    }

    mk14::Simulator &station() { return m_simulator; }
    void advance(SimulatedDevice::Time time) { m_now += time; }
    void setSilent(bool isSilent) { m_isSilent = isSilent; }
    int requests() const { return m_requests; }
    SimulatedDevice::Time elapsed() const { return std::chrono::duration_cast<SimulatedDevice::Time>(m_now - m_start); }

    Result<void> open() override { return {}; }
    void close() override { m_arrived.clear(); }
    bool isOpen() const override { return true; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds) override
    {
        ++m_requests;
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
    mk14::Simulator m_simulator;
    QByteArray m_arrived;
    SteadyTime m_start{std::chrono::hours(1)};
    SteadyTime m_now{m_start};
    bool m_isSilent = false;
    int m_requests = 0;
};

} // namespace gorizont::test
