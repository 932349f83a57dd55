#pragma once

#include "core/config/inifile.h"
#include "core/config/serverconfig.h"

#include <QFile>

/// How the tests of the configuration read it and what they compare.
namespace gorizont::test {

inline QByteArray readAll(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("[missing]");
}

inline QByteArray dataFile(const QString &name)
{
    return readAll(QStringLiteral(GORIZONT_TEST_DATA "/config/") + name);
}

inline ConfigReading read(const QByteArray &bytes)
{
    return readServerConfig(IniFile::fromBytes(bytes));
}

inline QStringList complaintTexts(const ConfigReading &reading)
{
    QStringList texts;
    for (const Complaint &complaint : reading.complaints) {
        texts.append(complaint.text());
    }
    return texts;
}

/// One sensor on one line for the tables below.
inline QString sensorText(const SensorConfig &sensor)
{
    const QStringList quantities{
        sensor.measuresTilt ? QStringLiteral("tilt") : QString(),
        sensor.measuresTemperature ? QStringLiteral("temperature") : QString(),
        sensor.measuresAcceleration ? QStringLiteral("acceleration") : QString(),
        sensor.hasThermostat ? QStringLiteral("heating") : QString()};
    return QStringLiteral("port %1 sensor %2: N %3, adr %4, %5, %6, SND3 %7, %8")
        .arg(sensor.port)
        .arg(sensor.index)
        .arg(sensor.number)
        .arg(sensor.address)
        .arg(
            sensor.isOn ? QStringLiteral("on") : QStringLiteral("off"), sensor.model, sensor.serialNumber,
            quantities.join(u' ').simplified());
}

inline QStringList sensorTexts(const ServerConfig &config)
{
    QStringList texts;
    for (const LineConfig &line : config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            texts.append(sensorText(sensor));
        }
    }
    return texts;
}

/// [Port1] with \a keys, the only port, on.
inline ConfigReading readPort(const QByteArray &keys)
{
    return read("[Common]\nNumOfPorts=1\n[Port1]\nOn=1\nNum=3\n" + keys);
}

} // namespace gorizont::test
