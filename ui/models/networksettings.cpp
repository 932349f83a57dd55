#include "ui/models/networksettings.h"

#include "ui/models/settingssection.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

namespace gorizont {

namespace {

using statetext::yesNo;

void addModbus(const ServerConfig &config, Properties &list)
{
    SettingsSection section(config, list, QStringLiteral("[Modbus TCP]"), QStringLiteral("Common"));
    section.add(
        "CanModbus", Settings::tr("Modbus TCP server"), yesNo(config.servesModbus),
        Settings::tr("serve readings over Modbus TCP?"));
    section.add(
        "ModbusPacking", Settings::tr("Order of the sensors"),
        config.modbusPacking == ModbusPacking::ByType ? Settings::tr("by type") : Settings::tr("by number"),
        Settings::tr("in units 3 and 6: every sensor of the type in turn, or a place for every site number"));
    section.add(
        "ModbusBase", Settings::tr("First register"), QString::number(config.modbusBase),
        Settings::tr("where the registers of units 3 and 6 start: 0 or 1"));
    section.add(
        "ModbusClients", Settings::tr("Clients at most"), QString::number(config.modbusClients),
        Settings::tr("connections at the same time"));
    section.add(
        "ModbusIdle", Settings::tr("Cut off silent clients"),
        config.modbusIdle.count() > 0 ? Settings::tr("after %1 s").arg(config.modbusIdle.count())
                                      : Settings::tr("never"),
        Settings::tr("how long a client may ask nothing"));
    section.add(
        "ModbusBind", Settings::tr("Address of the server"),
        config.modbusBind.isEmpty() ? Settings::tr("all") : config.modbusBind,
        Settings::tr("IP address of this computer to serve on"));
    section.add(
        "ModbusAllow", Settings::tr("Clients allowed"),
        config.modbusAllow.isEmpty() ? Settings::tr("all") : config.modbusAllow.join(QStringLiteral(", ")),
        Settings::tr("addresses and blocks of addresses that may connect"));
}

void addAdc24(const ServerConfig &config, Properties &list)
{
    SettingsSection section(config, list, QStringLiteral("[ADC24 TCP]"), QStringLiteral("Common"));
    section.add(
        "CanADC24", Settings::tr("ADC24 TCP server"), yesNo(config.servesAdc24),
        Settings::tr("serve the samples of one accelerometer over ADC24 TCP?"));
    section.add(
        "IPPort2", Settings::tr("IP port of ADC24"), QString::number(config.adc24Port),
        Settings::tr("number of the IP port for ADC24 TCP"));
    section.readFrom(QStringLiteral("ADC24"));
    section.add(
        "Sensor", Settings::tr("Accelerometer served"),
        config.adc24Sensor > 0 ? QString::number(config.adc24Sensor) : Settings::tr("the first"),
        Settings::tr("number of the sensor whose samples are served"));
    section.add(
        "Axis", Settings::tr("Axis served"),
        config.adc24Axis == Adc24Axis::X ? QStringLiteral("X") : QStringLiteral("Y"),
        Settings::tr("X or Y: the axis whose samples are served"));
}

/// Passwords are not shown.
void addMqttAccess(const MqttSettings &mqtt, SettingsSection &section)
{
    section.add(
        "User", Settings::tr("User"), valuetext::orAbsent(mqtt.user), Settings::tr("who the broker is told we are"));
    section.add(
        "PasswordFile", Settings::tr("File with the password"), valuetext::orAbsent(mqtt.passwordFile),
        Settings::tr("its first line is the password"));
    section.add("TLS", Settings::tr("Encrypted"), yesNo(mqtt.usesTls), Settings::tr("connect to the broker with TLS?"));
    section.add(
        "CAFile", Settings::tr("Certificates trusted"),
        mqtt.caFile.isEmpty() ? Settings::tr("those of the system") : mqtt.caFile,
        Settings::tr("PEM file of who signed the broker's certificate"));
    section.add(
        "CertFile", Settings::tr("Own certificate"), valuetext::orAbsent(mqtt.certFile),
        Settings::tr("PEM file that the broker may ask for"));
    section.add(
        "KeyFile", Settings::tr("Its key"), valuetext::orAbsent(mqtt.keyFile),
        Settings::tr("PEM file of the key of the own certificate"));
}

void addMqtt(const ServerConfig &config, Properties &list)
{
    const MqttSettings &mqtt = config.mqtt;
    SettingsSection section(config, list, QStringLiteral("[MQTT]"), QStringLiteral("MQTT"));
    section.add(
        "Host", Settings::tr("Broker"), mqtt.isOn() ? mqtt.host : Settings::tr("none"),
        Settings::tr("name or address of the broker that gets every reading"));
    if (!mqtt.isOn()) {
        return;
    }
    section.add(
        "Port", Settings::tr("Port of the broker"), QString::number(mqtt.port),
        Settings::tr("usually 1883, with TLS 8883"));
    addMqttAccess(mqtt, section);
    section.add(
        "ClientId", Settings::tr("Name for the broker"),
        mqtt.clientId.isEmpty() ? Settings::tr("made of the computer and the folder") : mqtt.clientId,
        Settings::tr("two copies with the same name throw each other out"));
    section.add(
        "Prefix", Settings::tr("Topics begin with"),
        mqtt.prefix.isEmpty() ? Settings::tr("the name of this copy") : mqtt.prefix,
        Settings::tr("what stands before sensor/… and port/… in each topic"));
    section.add(
        "QoS", Settings::tr("Quality of service"), QString::number(mqtt.qos),
        Settings::tr("0: may get lost, 1: at least once, 2: exactly once"));
    section.addTime("Interval", mqtt.interval, Settings::tr("least time between two readings of one sensor; 0: all"));
    section.add(
        "QueueLimit", Settings::tr("Queue at most"), Settings::tr("%1 MiB").arg(mqtt.queueLimit),
        Settings::tr("readings that wait on the disk while the broker is away"));
}

void addMetrics(const ServerConfig &config, Properties &list)
{
    const MetricsSettings &metrics = config.metrics;
    SettingsSection section(config, list, QStringLiteral("[Metrics]"), QStringLiteral("Metrics"));
    section.add(
        "Port", Settings::tr("Metrics for Prometheus"),
        metrics.isOn() ? Settings::tr("port %1").arg(metrics.port) : Settings::tr("off"),
        Settings::tr("number of the IP port where counters are served"));
    if (metrics.isOn()) {
        section.add(
            "Bind", Settings::tr("Address of the metrics"), metrics.bind, Settings::tr("IP address to serve on"));
    }
}

void addOpc(const ServerConfig &config, int gateways, Properties &list)
{
    if (!config.servesOpc) {
        return;
    }
    SettingsSection section(config, list, QStringLiteral("[OPC]"), QStringLiteral("OPC"));
    section.add(
        "Port", Settings::tr("Port for OPC DA gateways"), QString::number(config.opc.port),
        Settings::tr("number of the IP port where gateways on this computer get the tags"));
    section.add(
        QString(), Settings::tr("Gateways connected"), QString::number(gateways),
        Settings::tr("each serves any number of OPC clients"));
}

} // namespace

Properties networkSettings(const ServerConfig &config, int gateways)
{
    Properties list;
    addModbus(config, list);
    addAdc24(config, list);
    addMqtt(config, list);
    addMetrics(config, list);
    addOpc(config, gateways, list);
    return list;
}

} // namespace gorizont
