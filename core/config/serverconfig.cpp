#include "core/config/serverconfig.h"

#include "core/config/archivesettingsreader.h"
#include "core/config/chainreader.h"
#include "core/config/claims.h"
#include "core/config/feedsettingsreader.h"
#include "core/config/lineconfigreader.h"
#include "core/config/sectionreader.h"
#include "core/config/timingreader.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

void readProgram(SectionReader &common, ServerConfig &config)
{
    QString caption;
    common.take(u"Caption"_s, caption);
    if (!caption.isEmpty()) {
        config.caption = caption;
    }
    common.take(u"Name"_s, config.name);
    common.take(u"SerialNumber"_s, config.serialNumber);
    if (common.has(u"Language"_s)) {
        config.language = u"ru"_s;
        common.take<QString>(u"Language"_s, config.language, {{u"ru"_s, u"ru"_s}, {u"en"_s, u"en"_s}});
    }
    common.take(u"ShowAdvanced"_s, config.showsAdvanced);
    common.take(u"CanCopy"_s, config.allowsCopy);
    common.take(u"CanHide"_s, config.startsHidden);
    common.take(u"CanClose"_s, config.closesSilently);
    common.take(u"CanOPCDA"_s, config.servesOpc);
    if (config.servesOpc && config.allowsCopy) {
        common.complain(
            u"CanCopy"_s,
            QCoreApplication::translate("ServerConfig", "CanOPCDA=1 allows one copy of the program only."),
            QCoreApplication::translate("ServerConfig", "CanCopy=0 is used."));
        common.replace(u"CanCopy"_s);
        config.allowsCopy = false;
    }
}

void readStorage(SectionReader &common, ServerConfig &config)
{
    common.take(u"CanSave"_s, config.savesFiles);
    common.take(u"CanInfo"_s, config.asksInformation);
    common.take(u"MemoCount"_s, config.memoCount, {1});
    common.take(u"MemoDel"_s, config.memoDelete, {1});
    common.take(u"SrsBufSize"_s, config.ringPackets, {1, 1000000});
    common.take(u"SrsBufToSave"_s, config.packetsToSave, {1, 1000000});
    common.take(u"Gravity"_s, config.gravity, {9, 11});
    common.take(u"LegacyStatusBits"_s, config.hasLegacyStatusBits);
}

void readServers(SectionReader &common, ServerConfig &config)
{
    constexpr SectionReader::Range tcpPorts{1, 65535};
    common.take(u"IPPort1"_s, config.modbusPort, tcpPorts);
    common.take(u"IPPort2"_s, config.adc24Port, tcpPorts);
    common.take(u"CanModbus"_s, config.servesModbus);
    common.take(u"CanADC24"_s, config.servesAdc24);
    common.take<ModbusPacking>(
        u"ModbusPacking"_s, config.modbusPacking,
        {{u"ByType"_s, ModbusPacking::ByType}, {u"ByNumber"_s, ModbusPacking::ByNumber}});
    common.take(u"ModbusBase"_s, config.modbusBase, {0, 1});
    common.take(u"ModbusClients"_s, config.modbusClients, {1, 1000});
    common.take(u"ModbusIdle"_s, config.modbusIdle, {0});
    common.take(u"ModbusBind"_s, config.modbusBind);
    static const QRegularExpression separators(u"[,;\\s]+"_s);
    QString allowed;
    common.take(u"ModbusAllow"_s, allowed);
    config.modbusAllow = allowed.split(separators, Qt::SkipEmptyParts);
}

/// Two servers cannot have one port.
void settlePorts(SectionReader &common, ServerConfig &config)
{
    if (config.servesModbus && config.servesAdc24 && config.modbusPort == config.adc24Port) {
        common.complain(
            u"IPPort2"_s,
            QCoreApplication::translate("ServerConfig", "%1 is the port of Modbus TCP already.").arg(config.adc24Port),
            QCoreApplication::translate("ServerConfig", "ADC24 TCP is switched off."));
        common.replace(u"CanADC24"_s);
        config.servesAdc24 = false;
    }
}

/// The gateways have to find their port, so nothing else may be served there.
void settleOpcPort(const IniFile &file, Findings &findings, ServerConfig &config)
{
    if (!config.servesOpc) {
        return;
    }
    struct Server
    {
        bool isServed;
        int port;
        QString name;
    };
    const QList<Server> servers{
        {config.servesModbus, config.modbusPort, u"Modbus TCP"_s},
        {config.servesAdc24, config.adc24Port, u"ADC24 TCP"_s},
        {config.metrics.isOn(), config.metrics.port, u"[Metrics]"_s},
    };
    for (const Server &server : servers) {
        if (server.isServed && server.port == config.opc.port) {
            SectionReader(file, u"OPC"_s, findings)
                .complain(
                    u"Port"_s,
                    QCoreApplication::translate("ServerConfig", "%1 is the port of %2 already.")
                        .arg(QString::number(server.port), server.name),
                    QCoreApplication::translate("ServerConfig", "OPC DA is not served until another port is given."));
            SectionReader(file, u"Common"_s, findings).replace(u"CanOPCDA"_s);
            config.servesOpc = false;
            return;
        }
    }
}

bool hasAccelerometer(const QList<LineConfig> &lines, int number)
{
    return std::any_of(lines.begin(), lines.end(), [number](const LineConfig &line) {
        return std::any_of(line.sensors.begin(), line.sensors.end(), [number](const SensorConfig &sensor) {
            return sensor.number == number && sensor.measuresAcceleration;
        });
    });
}

/// The Cyrillic letters look the same and are taken for the Latin ones.
void readAxis(SectionReader &section, ServerConfig &config)
{
    QString written = u"X"_s;
    section.take(u"Axis"_s, written);
    const QString axis = written.toUpper().replace(u'Х', u'X').replace(u'У', u'Y');
    if (axis == u"X"_s || axis == u"Y"_s) {
        config.adc24Axis = axis == u"X"_s ? Adc24Axis::X : Adc24Axis::Y;
        return;
    }
    section.complain(
        u"Axis"_s, QCoreApplication::translate("ServerConfig", "%1 is none of %2.").arg(quoted(written), u"X, Y"_s),
        QCoreApplication::translate("ServerConfig", "The default %1 is used.").arg(u"X"_s));
    section.replace(u"Axis"_s);
}

void readAdc24(const IniFile &file, Findings &findings, ServerConfig &config)
{
    SectionReader section(file, u"ADC24"_s, findings);
    const QString first = QCoreApplication::translate("ServerConfig", "The first accelerometer is used.");
    section.take(u"Sensor"_s, config.adc24Sensor, {1}, first);
    if (config.adc24Sensor > 0 && !hasAccelerometer(config.lines, config.adc24Sensor)) {
        section.complain(
            u"Sensor"_s,
            QCoreApplication::translate("ServerConfig", "The site has no accelerometer with number %1.")
                .arg(config.adc24Sensor),
            first);
        section.replace(u"Sensor"_s);
        config.adc24Sensor = 0;
    }
    readAxis(section, config);
}

void complainOfSections(const IniFile &file, Findings &findings)
{
    const QString defaults = QCoreApplication::translate("ServerConfig", "The defaults of all its settings are used.");
    if (file.sections().isEmpty()) {
        findings.add(
            {{},
             {},
             0,
             QCoreApplication::translate("ServerConfig", "The file has no sections."),
             QCoreApplication::translate("ServerConfig", "The defaults of all settings are used, nothing is polled.")});
        return;
    }
    if (!file.hasSection(u"Common"_s)) {
        findings.add(
            {{}, {}, 0, QCoreApplication::translate("ServerConfig", "There is no section [Common]."), defaults});
    }
    if (file.hasSection(QString())) {
        findings.add(
            {{},
             {},
             file.sectionLine(QString()),
             QCoreApplication::translate("ServerConfig", "The line stands before the first section."),
             QCoreApplication::translate("ServerConfig", "All settings before the first section are ignored.")});
    }
}

/// What a sensor measures does not say that it has displacements.
void markChains(ServerConfig &config)
{
    QSet<int> numbers;
    for (const ChainConfig &chain : std::as_const(config.chains)) {
        for (const ChainLink &link : chain.links) {
            numbers.insert(link.number);
        }
    }
    for (LineConfig &line : config.lines) {
        for (SensorConfig &sensor : line.sensors) {
            sensor.isInChain = numbers.contains(sensor.number);
        }
    }
}

void complainOfRepetitions(const IniFile &file, Findings &findings)
{
    for (const IniFile::Entry &entry : file.repetitions()) {
        if (entry.key.isEmpty()) {
            findings.add(
                {entry.section,
                 {},
                 entry.line,
                 QCoreApplication::translate("ServerConfig", "The section begins in line %1 already.")
                     .arg(file.sectionLine(entry.section)),
                 QCoreApplication::translate("ServerConfig", "Of a key in both, the first one counts.")});
        } else if (const auto first = file.find(entry.section, entry.key)) {
            findings.add(
                {entry.section, entry.key, entry.line,
                 QCoreApplication::translate("ServerConfig", "The key stands in line %1 already.").arg(first->line),
                 QCoreApplication::translate("ServerConfig", "The first one counts.")});
        }
    }
}

/// Of the site; a sensor with a key of its own decides for itself.
void readUsmRevive(SectionReader &common, QList<LineConfig> &lines)
{
    bool revives = true;
    common.take(u"UsmRevive"_s, revives);
    for (LineConfig &line : lines) {
        for (SensorConfig &sensor : line.sensors) {
            if (!revives && sensor.type == SensorType::UsmIsn && !sensor.options.contains(u"usmrevive"_s)) {
                sensor.options.insert(u"usmrevive"_s, u"0"_s);
            }
        }
    }
}

} // namespace

ConfigReading readServerConfig(const IniFile &file)
{
    Findings findings;
    ServerConfig config;
    complainOfSections(file, findings);
    SectionReader common(file, u"Common"_s, findings);
    readProgram(common, config);
    readServers(common, config);
    settlePorts(common, config);
    readStorage(common, config);
    config.archive = readArchiveSettings(file, findings);
    config.mqtt = readMqttSettings(file, findings);
    config.metrics = readMetricsSettings(file, findings);
    config.opc = readOpcSettings(file, findings);
    settleOpcPort(file, findings, config);
    config.timing = readTiming(file, findings);
    config.lines = readLines(file, findings);
    readUsmRevive(common, config.lines);
    settleClaims(config.lines, file, findings);
    readAdc24(file, findings, config);
    config.chains = readChains(file, config.lines, findings);
    markChains(config);
    complainOfRepetitions(file, findings);
    config.replaced = findings.replaced();
    return {config, findings.complaints()};
}

} // namespace gorizont
