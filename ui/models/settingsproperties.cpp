#include "ui/models/settingsproperties.h"

#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

/// The translation context of the tab.
struct Settings
{
    Q_DECLARE_TR_FUNCTIONS(Settings)
};

using std::chrono::milliseconds;

/// Gathers the entries of one section of the ini and looks up what was replaced in it.
class Section
{
public:
    Section(const ServerConfig &config, Properties &list, const QString &iniSection)
        : m_config(config)
        , m_list(list)
        , m_section(iniSection)
    {
    }

    /// \a keys: as in the ini, all spellings of it, separated by `|`.
    void add(const QString &keys, const QString &name, const QString &value, const QString &note = {})
    {
        Property property{name, value, note};
        for (const QString &key : keys.split(u'|')) {
            const auto found = m_config.replaced.constFind((m_section + u'/' + key).toLower());
            if (found != m_config.replaced.cend()) {
                property.isReplaced = true;
                property.note = Settings::tr("the file gives “%1”, which cannot be used").arg(*found);
            }
        }
        m_list += property;
    }

    /// An entry that has no other name than its key.
    void addTime(const QString &keys, milliseconds time, const QString &meaning)
    {
        add(keys, keys.section(u'|', 0, 0), Settings::tr("%1 ms").arg(time.count()), meaning);
    }

    void addLimit(const QString &key, int limit, const QString &meaning)
    {
        add(key, key, QString::number(limit), meaning);
    }

private:
    const ServerConfig &m_config;
    Properties &m_list;
    QString m_section;
};

QString orAbsent(const QString &text)
{
    return text.isEmpty() ? valuetext::absent() : text;
}

QString portSection(int port)
{
    return QStringLiteral("Port%1").arg(port);
}

void addServer(const ServerConfig &config, Properties &list)
{
    list += Property::section(Settings::tr("[Server]"));
    Section section(config, list, QStringLiteral("Common"));
    section.add(QStringLiteral("Name"), Settings::tr("Comment"), orAbsent(config.name));
    section.add(
        QStringLiteral("IPPort1"), Settings::tr("IP port"), QString::number(config.modbusPort),
        config.servesModbus ? Settings::tr("Modbus TCP") : Settings::tr("Modbus TCP, switched off"));
}

void addTimers(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    list += Property::section(QStringLiteral("[Timers]"));
    Section section(config, list, QStringLiteral("Timers"));
    section.addTime(
        QStringLiteral("TmUpdateInt"), timing.updateInterval, Settings::tr("period of the visible elements"));
    section.addTime(QStringLiteral("TmRun"), timing.run, Settings::tr("period of polling a port"));
    section.addTime(QStringLiteral("TmStart"), timing.start, Settings::tr("time for resources at the start"));
    section.addTime(QStringLiteral("TmSave"), timing.save, Settings::tr("period of the records in the files"));
}

void addPauses(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    list += Property::section(QStringLiteral("[Pauses]"));
    Section section(config, list, QStringLiteral("Pauses"));
    section.addTime(QStringLiteral("PPauseTick"), timing.pauseTick, Settings::tr("slice of any pause"));
    section.addTime(
        QStringLiteral("PReOpen"), timing.reopenPause, Settings::tr("after a failed attempt to open a port"));
    section.addTime(
        QStringLiteral("PClose"), timing.closePause, Settings::tr("after closing a port, before it is opened again"));
    section.addTime(QStringLiteral("PExit"), timing.exitLimit, Settings::tr("time for an orderly end of the program"));
}

void addSleeps(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    list += Property::section(QStringLiteral("[Sleeps]"));
    Section section(config, list, QStringLiteral("Sleeps"));
    section.addTime(
        QStringLiteral("SAdrChange"), timing.addressChange, Settings::tr("after another address is chosen"));
    section.addTime(QStringLiteral("SIdle"), timing.idle, Settings::tr("after a polling cycle"));
    section.addTime(QStringLiteral("SRError"), timing.readErrorPause, Settings::tr("after a read error"));
    section.addTime(
        QStringLiteral("SCRCError|SCRCErr|SCRCErrors"), timing.crcErrorPause, Settings::tr("after a CRC error"));
}

void addTimeOuts(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    list += Property::section(QStringLiteral("[TimeOuts]"));
    Section section(config, list, QStringLiteral("TimeOuts"));
    section.addTime(QStringLiteral("TORCom"), timing.readCommand, Settings::tr("reading the answer to a command"));
    section.addTime(QStringLiteral("TOWCom"), timing.writeCommand, Settings::tr("writing a command"));
    section.addTime(QStringLiteral("TORDat"), timing.readData, Settings::tr("reading data"));
    section.addTime(QStringLiteral("TOWDat"), timing.writeData, Settings::tr("writing data"));
}

void addErrors(const ServerConfig &config, Properties &list)
{
    list += Property::section(QStringLiteral("[Errors]"));
    Section section(config, list, QStringLiteral("Errors"));
    section.addLimit(
        QStringLiteral("NumRErrSrs"), config.timing.readErrorLimit,
        Settings::tr("read errors in a row before the status word says so"));
    section.addLimit(
        QStringLiteral("NumCErrSrs"), config.timing.crcErrorLimit,
        Settings::tr("CRC errors in a row before the status word says so"));
}

void addMore(const ServerConfig &config, Properties &list)
{
    using statetext::yesNo;
    list += Property::section(Settings::tr("[More]"));
    Section section(config, list, QStringLiteral("Common"));
    section.add(QStringLiteral("CanSave"), Settings::tr("Save to files"), yesNo(config.savesFiles));
    section.add(QStringLiteral("MemoCount"), Settings::tr("Records shown"), QString::number(config.memoCount));
    section.add(QStringLiteral("MemoDel"), Settings::tr("Records cleared"), QString::number(config.memoDelete));
    section.add(QStringLiteral("CanHide"), Settings::tr("Hide to the tray at the start"), yesNo(config.startsHidden));
    section.add(QStringLiteral("CanClose"), Settings::tr("Warn at the end of work"), yesNo(!config.closesSilently));
    section.add(QStringLiteral("CanCopy"), Settings::tr("Allow a second copy"), yesNo(config.allowsCopy));
    section.add(QStringLiteral("ShowAdvanced"), Settings::tr("Allow adjustment"), yesNo(config.showsAdvanced));
    section.add(
        QStringLiteral("SrsBufSize"), Settings::tr("Accelerometer's buffer"),
        Settings::tr("%1 packets").arg(config.ringPackets), Settings::tr("32 samples of both axes each"));
}

} // namespace

Properties serverSettings(const ServerConfig &config)
{
    Properties list;
    addServer(config, list);
    addTimers(config, list);
    addPauses(config, list);
    addSleeps(config, list);
    addTimeOuts(config, list);
    addErrors(config, list);
    addMore(config, list);
    return list;
}

Properties lineSettings(const ServerConfig &config, const LineConfig &line)
{
    Properties list{Property::section(Settings::tr("[Port]"))};
    Section section(config, list, portSection(line.index));
    section.add(QStringLiteral("Name"), Settings::tr("Comment"), orAbsent(line.name));
    section.add(QStringLiteral("On"), Settings::tr("Switched on"), statetext::yesNo(line.isOn));
    section.add(QStringLiteral("Num|Device"), Settings::tr("Number"), line.title(), line.device);
    section.add(QStringLiteral("BaudRate"), QStringLiteral("BaudRate"), Settings::tr("%1 baud").arg(line.baudRate));
    return list;
}

Properties sensorSettings(const ServerConfig &config, const SensorConfig &sensor)
{
    const auto key = [&sensor](const char *name) { return QLatin1String(name) + QString::number(sensor.index); };
    const QString port = portSection(sensor.port);
    using statetext::yesNo;
    Properties list{Property::section(Settings::tr("[Sensor]"))};
    Section section(config, list, port);
    section.add(key("Name"), Settings::tr("Comment"), orAbsent(sensor.name));
    section.add(key("On"), Settings::tr("Polling"), yesNo(sensor.isOn));
    section.add(key("N"), Settings::tr("Number on the site"), QString::number(sensor.number));
    section.add(key("adr"), Settings::tr("Address on the line"), QString::number(sensor.address));
    section.add(key("SND3"), Settings::tr("Serial number"), orAbsent(sensor.serialNumber));
    list += Property::section(Settings::tr("[Adjustment]"));
    section.add(
        key("Xo"), Settings::tr("Offset Mx, degrees (arc-seconds)"), valuetext::degreesAndArcSeconds(sensor.offsetX));
    section.add(
        key("Yo"), Settings::tr("Offset My, degrees (arc-seconds)"), valuetext::degreesAndArcSeconds(sensor.offsetY));
    section.add(key("To"), Settings::tr("Offset T, °C"), valuetext::signedFixed(sensor.offsetT, 2));
    section.add(key("InvY"), Settings::tr("Inversion of axis Y"), yesNo(sensor.isYInverted));
    section.add(key("RotX"), Settings::tr("Rotation of axis X, degrees"), valuetext::signedFixed(sensor.rotationX, 3));
    section.add(key("SetData"), Settings::tr("Date of installation"), orAbsent(sensor.installedOn));
    section.add(key("AdjData"), Settings::tr("Date of the last adjustment"), orAbsent(sensor.adjustedOn));
    section.add(key("Note"), Settings::tr("Remark"), orAbsent(sensor.note));
    return list;
}

} // namespace gorizont
