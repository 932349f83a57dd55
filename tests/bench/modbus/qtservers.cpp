#include "core/modbus/modbusserver.h"
#include "tests/bench/modbus/payload.h"
#include "tests/bench/modbus/servers.h"

#include <QCoreApplication>
#include <QModbusTcpServer>
#include <QThread>

#include <cstdio>
#include <sys/socket.h>
#include <unistd.h>

namespace gorizont::bench {

namespace {

ModbusConfig site()
{
    ModbusConfig config;
    config.port = 0;
    config.desk.bind = QStringLiteral("127.0.0.1");
    config.desk.clients = 1024;
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    for (int i = 0; i < sensorCount; ++i) {
        SensorConfig sensor;
        sensor.port = 1;
        sensor.number = i + 1;
        sensor.isOn = true;
        sensor.type = SensorType::InD;
        sensor.measuresTilt = true;
        line.sensors.append(sensor);
    }
    config.lines = {line};
    return config;
}

Readings readings()
{
    constexpr double arcSeconds = 3.6; // in a thousandth of a degree
    Readings batch;
    for (int i = 0; i < sensorCount; ++i) {
        Reading reading;
        reading.number = i + 1;
        reading.isAnswer = true;
        reading.tilt = Tilt{arcSeconds * tiltOf(i).x, arcSeconds * tiltOf(i).y};
        batch.append(reading);
    }
    return batch;
}

LineStatus openLine()
{
    LineStatus status;
    status.port = 1;
    status.state = LineState::Open;
    return status;
}

/// QModbusTcpServer does not tell which port it was given.
int freePort()
{
    QTcpServer probe;
    probe.listen(QHostAddress::LocalHost);
    return probe.serverPort();
}

} // namespace

void tellPort(int port)
{
    std::printf("%d\n", port);
    std::fflush(stdout);
}

int serveOurs(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    ModbusServer server(site());
    QThread thread;
    server.moveToThread(&thread);
    QObject::connect(&thread, &QThread::started, &server, [&server] {
        server.updateLine(openLine());
        server.updateReadings(readings());
        server.connectDevice();
        tellPort(server.serverPort());
    });
    thread.start();
    return QCoreApplication::exec();
}

int serveQt(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QModbusTcpServer server;
    const int port = freePort();
    server.setServerAddress(unit);
    server.setConnectionParameter(QModbusDevice::NetworkPortParameter, port);
    server.setConnectionParameter(QModbusDevice::NetworkAddressParameter, QStringLiteral("127.0.0.1"));
    QModbusDataUnit registers(QModbusDataUnit::InputRegisters, 0, registerCount);
    for (int i = 0; i < registerCount; ++i) {
        registers.setValue(i, payloadRegister(i));
    }
    server.setMap({{QModbusDataUnit::InputRegisters, registers}});
    server.setData(registers);
    if (!server.connectDevice()) {
        return 1;
    }
    tellPort(port);
    return QCoreApplication::exec();
}

} // namespace gorizont::bench
