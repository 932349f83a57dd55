#include "tests/ui/samplesite.h"

namespace gorizont::test {

namespace {

SensorConfig tiltSensor(int port, int index, int number, int address)
{
    SensorConfig sensor;
    sensor.port = port;
    sensor.index = index;
    sensor.number = number;
    sensor.address = address;
    sensor.isOn = true;
    sensor.type = SensorType::InD;
    sensor.model = QStringLiteral("IN-D3");
    sensor.name = QStringLiteral("Инклинометр (ИН-Д3)");
    sensor.measuresTilt = true;
    return sensor;
}

SensorConfig accelerometer()
{
    SensorConfig sensor = tiltSensor(1, 1, 1, 12);
    sensor.type = SensorType::AnD3;
    sensor.model = QStringLiteral("AN-D3");
    sensor.name = QStringLiteral("АН1 (АН-Д3, TMP05, подогрев)");
    sensor.place = QStringLiteral("Этаж 2");
    sensor.serialNumber = QStringLiteral("804");
    sensor.installedOn = QStringLiteral("21.01.2017");
    sensor.adjustedOn = QStringLiteral("24.01.2017");
    sensor.note = QStringLiteral("Линия 1, терминал 120 Ом");
    sensor.measuresTemperature = true;
    sensor.measuresAcceleration = true;
    sensor.hasThermostat = true;
    sensor.offsetX = 100;
    sensor.offsetY = -3600;
    sensor.offsetT = 0.5;
    sensor.isYInverted = true;
    sensor.rotationX = 90;
    return sensor;
}

LineConfig line(int index, int com, bool isOn, const QList<SensorConfig> &sensors)
{
    LineConfig config;
    config.index = index;
    config.com = com;
    config.name = QStringLiteral("Moxa UPort %1").arg(1150 + index);
    config.isOn = isOn;
    config.sensors = sensors;
    return config;
}

} // namespace

ServerConfig sampleConfig()
{
    ServerConfig config;
    config.caption = QStringLiteral("Gorizont Server (тест)");
    config.name = QStringLiteral("Высотное здание");
    SensorConfig off = tiltSensor(2, 2, 4, 6);
    off.isOn = false;
    config.lines = {
        line(1, 4, true, {accelerometer(), tiltSensor(1, 2, 2, 24)}),
        line(2, 9, true, {tiltSensor(2, 1, 3, 5), off}),
        line(3, 2, false, {}),
    };
    config.timing.updateInterval = std::chrono::milliseconds(100);
    return config;
}

Reading sampleReading(SteadyTime now)
{
    Reading reading;
    reading.number = 1;
    reading.time = utcNow();
    reading.isAnswer = true;
    reading.answeredAt = now;
    reading.tilt = Tilt{-3599.5, 2720.5};
    reading.temperature = 21.384;
    reading.heaterPower = 45.31;
    reading.fanFrequency = 41.02;
    reading.acceleration = AccelStatistics{7.67, -0.001, -7.67, 270, 2.19, 0, 2.19};
    reading.rawStatus = 0x240F;
    reading.rawMode = 0xCC00;
    reading.ring = RingProgress{179, 179};
    reading.counters = {1000, 3, 2};
    reading.period = std::chrono::microseconds(1002000);
    reading.exchange = std::chrono::microseconds(31000);
    return reading;
}

Reading tiltReading(int number, double x, double y, SteadyTime now)
{
    Reading reading;
    reading.number = number;
    reading.time = utcNow();
    reading.isAnswer = true;
    reading.answeredAt = now;
    reading.status = statusbit::TemperatureInvalid | statusbit::AccelerationInvalid;
    reading.tilt = Tilt{x, y};
    return reading;
}

LineStatus openLine(int port, SteadyTime since)
{
    LineStatus status;
    status.port = port;
    status.state = LineState::Open;
    status.openedAt = since;
    status.pollingAt = since;
    return status;
}

} // namespace gorizont::test
