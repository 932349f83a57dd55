// The entries of the server (manual 000, section 4.6), then those the manual's list leaves out.

#include "ui/models/networksettings.h"
#include "ui/models/settingsproperties.h"
#include "ui/models/settingssection.h"
#include "ui/models/statetext.h"
#include "ui/models/storagesettings.h"
#include "ui/models/valuetext.h"

namespace gorizont {

namespace {

using statetext::yesNo;

void addServer(const ServerConfig &config, Properties &list)
{
    SettingsSection section(config, list, Settings::tr("[Server]"), QStringLiteral("Common"));
    section.add(
        "Name", Settings::tr("Comment"), valuetext::orAbsent(config.name),
        Settings::tr("short description of this copy of the program"));
    section.add(
        "IPPort1", Settings::tr("IP port"), QString::number(config.modbusPort),
        config.servesModbus ? Settings::tr("number of the IP port for Modbus TCP")
                            : Settings::tr("number of the IP port for Modbus TCP, switched off by CanModbus=0"));
}

void addTimers(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    SettingsSection section(config, list, QStringLiteral("[Timers]"), QStringLiteral("Timers"));
    section.addTime(
        "TmUpdateInt", timing.updateInterval, Settings::tr("period of drawing the visible elements of the program"));
    section.addTime("TmRun", timing.run, Settings::tr("period of polling the COM ports"));
    section.addTime("TmStart", timing.start, Settings::tr("time for resources of the program at its start"));
    section.addTime("TmSave", timing.save, Settings::tr("period of saving the measurements in files"));
}

void addPauses(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    SettingsSection section(config, list, QStringLiteral("[Pauses]"), QStringLiteral("Pauses"));
    section.addTime("PPauseTick", timing.pauseTick, Settings::tr("slice of any pause"));
    section.addTime("PReOpen", timing.reopenPause, Settings::tr("pause after a failed attempt to open a COM port"));
    section.addTime(
        "PClose", timing.closePause, Settings::tr("pause after closing a COM port, before it is opened again"));
    section.addTime(
        "PExit", timing.exitLimit, Settings::tr("time for an orderly end of the program; then it is ended by force"));
}

void addSleeps(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    SettingsSection section(config, list, QStringLiteral("[Sleeps]"), QStringLiteral("Sleeps"));
    section.addTime("SAdrChange", timing.addressChange, Settings::tr("pause after another address is chosen"));
    section.addTime("SIdle", timing.idle, Settings::tr("pause after a polling cycle"));
    section.addTime("SRError", timing.readErrorPause, Settings::tr("pause after a read error"));
    section.addTime("SCRCError|SCRCErr|SCRCErrors", timing.crcErrorPause, Settings::tr("pause after a CRC error"));
}

void addTimeOuts(const ServerConfig &config, Properties &list)
{
    const Timing &timing = config.timing;
    SettingsSection section(config, list, QStringLiteral("[TimeOuts]"), QStringLiteral("TimeOuts"));
    section.addTime("TORCom", timing.readCommand, Settings::tr("timeout of reading a command from a COM port"));
    section.addTime("TOWCom", timing.writeCommand, Settings::tr("timeout of writing a command to a COM port"));
    section.addTime("TORDat", timing.readData, Settings::tr("timeout of reading data from a COM port"));
    section.addTime("TOWDat", timing.writeData, Settings::tr("timeout of writing data to a COM port"));
}

void addErrors(const ServerConfig &config, Properties &list)
{
    SettingsSection section(config, list, QStringLiteral("[Errors]"), QStringLiteral("Errors"));
    section.addLimit(
        "NumRErrSrs", config.timing.readErrorLimit,
        Settings::tr("read errors in a row before the status word of the sensor says so"));
    section.addLimit(
        "NumCErrSrs", config.timing.crcErrorLimit,
        Settings::tr("CRC errors in a row before the status word of the sensor says so"));
}

void addMore(const ServerConfig &config, Properties &list)
{
    SettingsSection section(config, list, Settings::tr("[More]"), QStringLiteral("Common"));
    section.add(
        "CanSave", Settings::tr("Save to files"), yesNo(config.savesFiles),
        Settings::tr("save measurements and the journal of events in files?"));
    section.add(
        "MemoCount", Settings::tr("Records shown"), QString::number(config.memoCount),
        Settings::tr("number of the last records on the tab of measurements"));
    section.add(
        "MemoDel", Settings::tr("Records cleared"), QString::number(config.memoDelete),
        Settings::tr("number of records removed from the tab of measurements when it is full"));
    section.add(
        "CanHide", Settings::tr("Hide to the tray at the start"), yesNo(config.startsHidden),
        Settings::tr("hide the window of the program in the tray at its start?"));
    section.add(
        "CanClose", Settings::tr("Warn at the end of work"), yesNo(!config.closesSilently),
        Settings::tr("show a warning when the program is closed? (CanClose=0)"));
    section.add(
        "CanCopy", Settings::tr("Allow a second copy"), yesNo(config.allowsCopy),
        Settings::tr("allow copies of the program to run at the same time?"));
    section.add(
        "ShowAdvanced", Settings::tr("Allow adjustment"), yesNo(config.showsAdvanced),
        Settings::tr("show additional elements of the program?"));
    section.add(
        "SrsBufSize", Settings::tr("Accelerometer's buffer"), Settings::tr("%1 packets").arg(config.ringPackets),
        Settings::tr("size of the accelerometer's ring; a packet holds 32 samples along X and Y"));
}

void addProgram(const ServerConfig &config, Properties &list)
{
    SettingsSection section(config, list, Settings::tr("[Program]"), QStringLiteral("Common"));
    section.add("Caption", Settings::tr("Caption of the window"), config.caption, Settings::tr("title of the window"));
    section.add(
        "Language", Settings::tr("Language"), config.language.isEmpty() ? QStringLiteral("ru") : config.language,
        Settings::tr("language of the program: ru or en; --lang goes before it"));
    section.add(
        "SerialNumber", Settings::tr("Serial number of the copy"), valuetext::orAbsent(config.serialNumber),
        Settings::tr("kept, without any effect"));
    section.add(
        "NumOfPorts", Settings::tr("Ports listed"), QString::number(config.lines.size()),
        Settings::tr("number of COM ports in the configuration file"));
    section.add(
        "CanInfo", Settings::tr("Ask for information"), yesNo(config.asksInformation),
        Settings::tr("ask sensors for additional information about their state?"));
    section.add(
        "SrsBufToSave", Settings::tr("Buffers in a file"), QString::number(config.packetsToSave),
        Settings::tr("samples of acceleration in one binary file: %1 (SrsBufSize × 32 × SrsBufToSave)")
            .arg(qint64(config.ringPackets) * 32 * config.packetsToSave));
    section.add(
        "Gravity", Settings::tr("Gravity, m/s²"), QString::number(config.gravity, 'g', 10),
        Settings::tr("acceleration of free fall, by which raw accelerations become mm/s²"));
    section.add(
        "LegacyStatusBits", Settings::tr("Status bits of the original"), yesNo(config.hasLegacyStatusBits),
        Settings::tr("print the status words as the original program did?"));
    section.add(
        "CanOPCDA", Settings::tr("OPC DA interface"), yesNo(config.servesOpc),
        Settings::tr("serve OPC DA? Only one copy of the program may run then"));
}

} // namespace

Properties serverSettings(const ServerConfig &config, int gateways)
{
    Properties list;
    addServer(config, list);
    addTimers(config, list);
    addPauses(config, list);
    addSleeps(config, list);
    addTimeOuts(config, list);
    addErrors(config, list);
    addMore(config, list);
    addProgram(config, list);
    return list + storageSettings(config) + networkSettings(config, gateways);
}

} // namespace gorizont
