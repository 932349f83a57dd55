#include "ui/models/stateproperties.h"

#include "ui/models/informationproperties.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

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

/// A sensor without words of its own shows nothing here; the computed word stands in the table of sensors.
QString statusNote(const Reading &reading)
{
    return SensorPage::tr("flags of the state : of the mode, as the sensor gives them; the program's own word is %1")
        .arg(valuetext::status(reading.status));
}

} // namespace

Properties portProperties(const SensorRegistry::Line &line, SteadyTime now)
{
    const LineStatus &status = line.status;
    return {
        {PortPage::tr("Comment"), line.config.name, {}},
        {PortPage::tr("State"), statetext::line(status.state), {}},
        {PortPage::tr("Polling time"), since(status.pollingAt, now), PortPage::tr("how long polled without a break")},
        {PortPage::tr("Time since opening"), since(status.openedAt, now), {}},
        {PortPage::tr("Bytes sent"), QString::number(status.bytesSent), {}},
        {PortPage::tr("Bytes received"), QString::number(status.bytesReceived), {}},
        {PortPage::tr("Attempts to open"), QString::number(status.failedOpens), PortPage::tr("those that failed")},
        {PortPage::tr("Write errors"), QString::number(status.writeErrors), {}},
        {PortPage::tr("Read errors"), QString::number(status.readErrors), {}},
        {PortPage::tr("CRC errors"), QString::number(status.crcErrors), {}},
        {PortPage::tr("Code of the last error"), lastError(status), {}},
    };
}

Properties sensorProperties(const SensorRegistry::Sensor &sensor, LineState line, SteadyTime now)
{
    const Reading &reading = sensor.reading;
    Properties rows{
        {SensorPage::tr("Comment"), sensor.config.name, {}},
        {SensorPage::tr("State"), statetext::sensor(sensor, line), {}},
        {SensorPage::tr("Angles Mx, My, degrees (arc-seconds)"), valuetext::tilt(validTilt(reading)), {}},
        {SensorPage::tr("Accelerations Ax, Ay, mm/s²"),
         valuetext::acceleration(validAcceleration(reading), reading.ring, sensor.packetsSaved),
         accelerationNote(reading)},
        {SensorPage::tr("Temperature T, °C"), valuetext::fixed(validTemperature(reading), 2), {}},
        // Only the weather station measures wind, and its readings do not come this way.
        {SensorPage::tr("Wind speed U, V, m/s"), valuetext::absent(), {}},
        {SensorPage::tr("Thermostat, % (rev/s)"),
         valuetext::thermostat(validHeaterPower(reading), validFanFrequency(reading)),
         SensorPage::tr("power of the heater (frequency of the fan)")},
        {SensorPage::tr("Status word"), valuetext::words(reading.rawStatus, reading.rawMode), statusNote(reading)},
        {SensorPage::tr("Polling period, s"), valuetext::poll(reading, now),
         SensorPage::tr("period | time of the exchange | age of the values")},
        {SensorPage::tr("Read errors"), QString::number(reading.counters.readErrors), {}},
        {SensorPage::tr("CRC errors"), QString::number(reading.counters.crcErrors), {}},
    };
    rows += informationProperties(sensor);
    return rows;
}

} // namespace gorizont
