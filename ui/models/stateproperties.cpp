#include "ui/models/stateproperties.h"

#include "ui/models/informationproperties.h"
#include "ui/models/statetext.h"
#include "ui/models/statusmeaning.h"
#include "ui/models/valuetext.h"
#include "ui/models/vibrationproperties.h"
#include "ui/models/weatherproperties.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

/// The translation contexts of the two pages.
struct PortPage
{
    Q_DECLARE_TR_FUNCTIONS(PortPage)
};
struct SensorPage
{
    Q_DECLARE_TR_FUNCTIONS(SensorPage)
};

QString since(const std::optional<SteadyTime> &start, SteadyTime now)
{
    return start ? valuetext::duration(now - *start) : valuetext::absent();
}

QString lastError(const LineStatus &status)
{
    const QString code = QString::number(status.lastErrorCode);
    return status.lastError.isEmpty() ? code : QStringLiteral("%1 (%2)").arg(code, status.lastError);
}

/// The manual's "maximum along X and along Y", for which the row itself has no room.
QString accelerationNote(const Reading &reading)
{
    const QString meaning = SensorPage::tr("modulus of the maximum, its direction, degrees (RMS of the modulus | along "
                                           "X, along Y), packets in the sensor : read (samples) saved");
    const auto accel = validAcceleration(reading);
    if (!accel) {
        return meaning;
    }
    return SensorPage::tr("maximum along X %1, along Y %2 mm/s²")
               .arg(valuetext::signedFixed(accel->maximumX, 2), valuetext::signedFixed(accel->maximumY, 2))
        + u'\n' + meaning;
}

/// A sensor without words of its own shows a dash; what the program makes of its state stands here all the same.
QString statusNote(const SensorConfig &sensor, const Reading &reading)
{
    QString note = SensorPage::tr("flags of the state : flags of the mode, as the sensor gives them");
    const QString raw = statusmeaning::rawWord(sensor, reading);
    if (!raw.isEmpty()) {
        note += u'\n' + raw;
    }
    return note + QStringLiteral("\n\n")
        + SensorPage::tr("the program's own word: %1").arg(valuetext::status(reading.status).trimmed()) + u'\n'
        + statusmeaning::word(reading);
}

Property stateRow(const QString &name, const QString &state, const QString &note, Health health)
{
    Property row{name, state, note};
    row.health = health;
    return row;
}

} // namespace

Properties portProperties(const SensorRegistry::Line &line, SteadyTime now)
{
    const LineStatus &status = line.status;
    return {
        {PortPage::tr("Comment"), valuetext::orAbsent(line.config.name), PortPage::tr("short description of the port")},
        stateRow(
            PortPage::tr("State"), statetext::line(status.state), PortPage::tr("state of the port"),
            lineHealth(status.state)),
        {PortPage::tr("Polling time"), since(status.pollingAt, now),
         PortPage::tr("how long the port is polled without a break, h:mm:ss")},
        {PortPage::tr("Time since opening"), since(status.openedAt, now),
         PortPage::tr("how long the port works without a break, h:mm:ss")},
        {PortPage::tr("Bytes sent"), QString::number(status.bytesSent),
         PortPage::tr("number of bytes sent to the port")},
        {PortPage::tr("Bytes received"), QString::number(status.bytesReceived),
         PortPage::tr("number of bytes received from the port")},
        {PortPage::tr("Attempts to open"), QString::number(status.failedOpens),
         PortPage::tr("number of failed attempts to open the port")},
        {PortPage::tr("Write errors"), QString::number(status.writeErrors),
         PortPage::tr("number of errors of writing to the port")},
        {PortPage::tr("Read errors"), QString::number(status.readErrors),
         PortPage::tr("number of errors of reading from the port")},
        {PortPage::tr("CRC errors"), QString::number(status.crcErrors),
         PortPage::tr("number of CRC errors in what was read from the port")},
        {PortPage::tr("Code of the last error"), lastError(status),
         PortPage::tr("code of the system and its meaning; 0: no error so far")},
    };
}

Properties sensorProperties(const SensorRegistry::Sensor &sensor, LineState line, SteadyTime now)
{
    const Reading &reading = sensor.reading;
    const SensorConfig &config = sensor.config;
    Properties rows{
        {SensorPage::tr("Comment"), valuetext::orAbsent(config.name),
         SensorPage::tr("short description of the sensor")},
        stateRow(
            SensorPage::tr("State"), statetext::sensor(sensor, line), SensorPage::tr("state of the sensor"),
            sensorHealth(sensor, line)),
        {SensorPage::tr("Angles Mx, My, degrees (arc-seconds)"), valuetext::tilt(validTilt(reading)),
         SensorPage::tr("angle along X, angle along Y, degrees (the same in arc-seconds)")},
        {SensorPage::tr("Accelerations Ax, Ay, mm/s²"),
         valuetext::acceleration(validAcceleration(reading), reading.ring, sensor.packetsSaved),
         accelerationNote(reading)},
        {SensorPage::tr("Temperature T, °C"), valuetext::fixed(validTemperature(reading), 2),
         SensorPage::tr("temperature, if the sensor measures it")},
        {SensorPage::tr("Wind speed U, V, m/s"), windComponents(sensor, line),
         SensorPage::tr("speed of the wind, if the sensor measures it")},
        {SensorPage::tr("Thermostat, % (rev/s)"),
         valuetext::thermostat(validHeaterPower(config, reading), validFanFrequency(config, reading)),
         SensorPage::tr("power of the heater, % (frequency of the fan, revolutions per second)")},
        {SensorPage::tr("Status word"), valuetext::words(reading.rawStatus, reading.rawMode),
         statusNote(config, reading)},
        {SensorPage::tr("Polling period, s"), valuetext::poll(reading, now),
         SensorPage::tr("actual period of polling | time of the exchange | age of the values")},
        {SensorPage::tr("Read errors"), QString::number(reading.counters.readErrors),
         SensorPage::tr("number of errors of reading from the sensor")},
        {SensorPage::tr("CRC errors"), QString::number(reading.counters.crcErrors),
         SensorPage::tr("number of CRC errors in what was read from the sensor")},
    };
    rows += informationProperties(sensor);
    rows += vibrationProperties(sensor);
    rows += weatherProperties(sensor, line);
    return rows;
}

} // namespace gorizont
