// The entries of a port and of a sensor (manual 000, sections 4.7 and 4.8), then those the manual's list leaves out.

#include "ui/models/settingsproperties.h"
#include "ui/models/settingssection.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

#include <algorithm>

namespace gorizont {

namespace {

using statetext::yesNo;

QString iniSection(int port)
{
    return QStringLiteral("Port%1").arg(port);
}

QString parityText(Parity parity)
{
    switch (parity) {
    case Parity::None: return Settings::tr("none");
    case Parity::Even: return Settings::tr("even");
    case Parity::Odd: return Settings::tr("odd");
    case Parity::Mark: return Settings::tr("mark");
    case Parity::Space: return Settings::tr("space");
    }
    return {};
}

QString stopBitsText(StopBits bits)
{
    switch (bits) {
    case StopBits::One: return QStringLiteral("1");
    case StopBits::OneAndHalf: return QStringLiteral("1.5");
    case StopBits::Two: return QStringLiteral("2");
    }
    return {};
}

QString measuredText(const SensorConfig &sensor)
{
    QStringList list;
    const auto add = [&list](bool isMeasured, const QString &what) {
        if (isMeasured) {
            list += what;
        }
    };
    add(sensor.measuresTilt, Settings::tr("angles"));
    add(sensor.measuresTemperature, Settings::tr("temperature"));
    add(sensor.measuresAcceleration, Settings::tr("accelerations"));
    return valuetext::orAbsent(list.join(QStringLiteral(", ")));
}

/// Names of keys with the number of the sensor behind them.
class SensorKeys
{
public:
    explicit SensorKeys(const SensorConfig &sensor)
        : m_index(QString::number(sensor.index))
    {
    }
    QString operator()(const QString &name) const { return name + m_index; }
    QString operator()(const char *name) const { return QLatin1String(name) + m_index; }

private:
    QString m_index;
};

void addSensor(const ServerConfig &config, const SensorConfig &sensor, Properties &list)
{
    const SensorKeys key(sensor);
    SettingsSection section(config, list, Settings::tr("[Sensor]"), iniSection(sensor.port));
    section.add(
        key("Name"), Settings::tr("Comment"), valuetext::orAbsent(sensor.name),
        Settings::tr("information about the sensor; its keywords tell what the sensor is able to do"));
    section.add(
        key("On"), Settings::tr("Polling"), yesNo(sensor.isOn),
        Settings::tr("take the sensor into the polling cycle?"));
    section.add(
        key("N"), Settings::tr("Number on the site"), QString::number(sensor.number),
        Settings::tr("number of the sensor on the site"));
    section.add(
        key("adr"), Settings::tr("Address on the line"), QString::number(sensor.address),
        Settings::tr("address of the sensor on the line"));
    section.add(
        key("SND3"), Settings::tr("Serial number"), valuetext::orAbsent(sensor.serialNumber),
        Settings::tr("works number of the primary transducer"));
}

void addAdjustment(const ServerConfig &config, const SensorConfig &sensor, Properties &list)
{
    const SensorKeys key(sensor);
    SettingsSection section(config, list, Settings::tr("[Adjustment]"), iniSection(sensor.port));
    section.add(
        key("Xo"), Settings::tr("Offset Mx, degrees (arc-seconds)"), valuetext::degreesAndArcSeconds(sensor.offsetX),
        Settings::tr("zero offset along X after the adjustment; in the file in arc-seconds"));
    section.add(
        key("Yo"), Settings::tr("Offset My, degrees (arc-seconds)"), valuetext::degreesAndArcSeconds(sensor.offsetY),
        Settings::tr("zero offset along Y after the adjustment; in the file in arc-seconds"));
    section.add(
        key("To"), Settings::tr("Offset T, °C"),
        sensor.measuresTemperature ? valuetext::signedFixed(sensor.offsetT, 2) : valuetext::absent(),
        Settings::tr("zero correction of the temperature sensor, °C; sensors without temperature have none"));
    section.add(
        key("InvY"), Settings::tr("Inversion of axis Y"), yesNo(sensor.isYInverted),
        Settings::tr("invert the axis Y of the sensor's coordinate system?"));
    section.add(
        key("RotX"), Settings::tr("Rotation of axis X, degrees"), valuetext::signedFixed(sensor.rotationX, 3),
        Settings::tr("angle of the sensor's coordinate system against that of the site, degrees"));
    section.add(
        key("SetData"), Settings::tr("Date of installation"), valuetext::orAbsent(sensor.installedOn),
        Settings::tr("date when the sensor was installed"));
    section.add(
        key("AdjData"), Settings::tr("Date of the last adjustment"), valuetext::orAbsent(sensor.adjustedOn),
        Settings::tr("date when the sensor was last adjusted"));
    section.add(
        key("Note"), Settings::tr("Remark"), valuetext::orAbsent(sensor.note),
        Settings::tr("additional information about the sensor"));
}

void addMore(const ServerConfig &config, const SensorConfig &sensor, Properties &list)
{
    const SensorKeys key(sensor);
    SettingsSection section(config, list, Settings::tr("[More]"), iniSection(sensor.port));
    section.add(
        key("Place"), Settings::tr("Place"), valuetext::orAbsent(sensor.place),
        Settings::tr("place of the sensor, shown in the tree"));
    section.add(
        QString(), Settings::tr("Type"), valuetext::orAbsent(modelInRussian(sensor.model)),
        Settings::tr("by the keywords of the comment"));
    section.add(
        key("AccelOn"), Settings::tr("Measures"), measuredText(sensor),
        Settings::tr("what the type is able to measure; AccelOn=0 leaves out the accelerations"));
    section.add(
        QString(), Settings::tr("Thermostat"), yesNo(sensor.hasThermostat),
        Settings::tr("by the keywords of the comment; fan and heater count in the status word"));
    QStringList options = sensor.options.keys();
    std::sort(options.begin(), options.end());
    for (const QString &option : std::as_const(options)) {
        section.add(
            key(option), key(option), valuetext::orAbsent(sensor.options.value(option)),
            Settings::tr("an option of this type of sensor"));
    }
}

} // namespace

Properties lineSettings(const ServerConfig &config, const LineConfig &line)
{
    Properties list;
    SettingsSection section(config, list, Settings::tr("[Port]"), iniSection(line.index));
    section.add(
        "Name", Settings::tr("Comment"), valuetext::orAbsent(line.name),
        Settings::tr("short description of the port's adapter"));
    section.add(
        "On", Settings::tr("Switched on"), yesNo(line.isOn), Settings::tr("take the port into the polling cycle?"));
    section.add("Num", Settings::tr("Number"), line.title(), Settings::tr("name of the port in the operating system"));
    section.add(
        "BaudRate", QStringLiteral("BaudRate"), Settings::tr("%1 baud").arg(line.baudRate),
        Settings::tr("speed of transmission, baud"));

    SettingsSection more(config, list, Settings::tr("[More]"), iniSection(line.index));
    more.add(
        "Device", Settings::tr("Device"), valuetext::orAbsent(line.device),
        Settings::tr("opened instead of the port of that number: a path, COM4, tcp://host:port, sim:"));
    more.add("DataBits", Settings::tr("Data bits"), QString::number(line.dataBits), Settings::tr("5 … 8"));
    more.add("Parity", Settings::tr("Parity"), parityText(line.parity), Settings::tr("N, E, O, M or S"));
    more.add("StopBits", Settings::tr("Stop bits"), stopBitsText(line.stopBits), Settings::tr("1, 1.5 or 2"));
    more.add(
        "RS485", QStringLiteral("RS485"), yesNo(line.isRs485),
        Settings::tr("does the driver of the adapter control the direction?"));
    more.add(
        "NumOfSensors", Settings::tr("Sensors listed"), QString::number(line.sensors.size()),
        Settings::tr("number of sensors connected to the port"));
    return list;
}

Properties sensorSettings(const ServerConfig &config, const SensorConfig &sensor)
{
    Properties list;
    addSensor(config, sensor, list);
    addAdjustment(config, sensor, list);
    addMore(config, sensor, list);
    return list;
}

} // namespace gorizont
