#include "core/devices/ind3/ind3simulator.h"

namespace gorizont::ind3 {

namespace {

constexpr quint32 firstSerialNumber = 5000; ///< of sensors whose `SND3` is no number

SimulatedSensor sensorFor(const SensorConfig &config, quint64 seed)
{
    SimulatedSensor sensor{.motion = BuildingMotion(seed, config.number)};
    sensor.address = config.address;
    sensor.dialect = dialectNamed(config.options.value(dialectOption)).value_or(Dialect::V211);
    bool isNumber = false;
    const quint32 serialNumber = config.serialNumber.toUInt(&isNumber);
    sensor.serialNumber = isNumber ? serialNumber : firstSerialNumber + static_cast<quint32>(config.number);
    return sensor;
}

} // namespace

Simulator::Simulator(const SensorConfig &sensor, quint64 seed)
    : SimulatedDevice(sensor.number, sensor.address)
    , m_sensor(sensorFor(sensor, seed))
{
}

QByteArray Simulator::receive(QByteArrayView bytes, Time now)
{
    QByteArray answers;
    for (const char byte : bytes) {
        answers += hear(byte, now);
    }
    setAddress(m_sensor.address);
    return answers;
}

QByteArray Simulator::hear(char byte, Time now)
{
    if (m_sensor.isInBootLoader) {
        return {};
    }
    switch (m_sensor.dialect) {
    case Dialect::V211: return m_port211.hear(byte, m_sensor, now);
    case Dialect::V210: return m_port210.hear(byte, m_sensor, now);
    case Dialect::Modbus: return m_portModbus.hear(byte, m_sensor, now);
    }
    return {};
}

void Simulator::reboot(Time)
{
    m_sensor.isInBootLoader = false;
    m_port211.clear();
    m_port210.clear();
    m_portModbus.clear();
}

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed)
{
    return std::make_unique<Simulator>(sensor, seed);
}

} // namespace gorizont::ind3
