#include "app/tool/usage.h"

#include "app/tool/command.h"
#include "app/tool/text.h"

#include <QCommandLineParser>
#include <QRegularExpression>

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;

constexpr int commandColumn = 27;

QString commandTable()
{
    QString table;
    for (const Command &command : commands()) {
        const QString call = command.arguments.isEmpty() ? command.name : command.name + u' ' + command.arguments;
        table += u"  "_s + call.leftJustified(commandColumn) + command.description + u'\n';
    }
    return table;
}

QString jsonKeys()
{
    return Text::tr(
        "JSON, one object a line; what is not known is null:\n"
        "  every one      type (ind3, and3, usm), address\n"
        "  scan, info     ind3: protocol, version, revision, serial, baud, name, offsetX, offsetY (arc-seconds),\n"
        "                 ticks, period (ms), selfTest; and3: firmware, build, configuration (hexadecimal)\n"
        "                 and the keys of read\n"
        "  read           time (UTC), tiltX, tiltY (arc-seconds); and3: temperature (°C), fanFrequency (1/s),\n"
        "                 heaterPower (%), rawStatus, rawMode, samples\n"
        "  set-…, reset   setting (name, offset, ticks, period, address, reset), done; address: newAddress\n"
        "  usm serial     serial; find: serial\n"
        "  usm info       deviceType, serial, program, calibratedOn (dates), calibrations, channels (id, type, units,\n"
        "                 description)\n"
        "  usm value,     state (measured, out of range, sensor error), time (UTC), timestamp (s), serial, channel,\n"
        "  usm records    measurement, value, variation (degrees), temperature (°C)\n"
        "  usm …          setting (address, port, recorder), done; address: newAddress; port: isProbed\n"
        "  a failure      fault: timeout, checksum, bad reply, refused, closed, cancelled");
}

QString description()
{
    return Text::tr("Finds, reads and sets ИН-Д3, АН-Д3 and УСМ-ИСН sensors on a serial line. The line must not be "
                    "open in another "
                    "program.")
        + u"\n\n"_s + Text::tr("Commands:") + u'\n' + commandTable() + u'\n'
        + Text::tr("gorizont-tool archive --help and gorizont-tool export --help tell of the archive of readings.")
        + u'\n' + Text::tr("gorizont-tool vims --help tells of L-VIMS vibration modules.") + u'\n'
        + Text::tr("gorizont-tool mk14 --help tells of МК-14 weather stations.") + u"\n\n"_s
        + Text::tr("Exit codes: 0 done; 1 refused by the sensor or by the user; 2 the command line is wrong; 3 no "
                   "answer, or "
                   "the port cannot be opened.")
        + u"\n\n"_s + jsonKeys() + u"\n\n"_s + Text::tr("Examples:")
        + u"\n  gorizont-tool scan --device /dev/ttyUSB0 --baud 9600 --type ind3"
          "\n  gorizont-tool set-offset 200,5 -300 --device COM4 --type ind3 --address 24"
          "\n  gorizont-tool read --device tcp://10.0.0.5:4001 --type and3 --address 1 --count 0 --json"_s;
}

} // namespace

void describeUsage(QCommandLineParser &parser)
{
    parser.setApplicationDescription(description());
    parser.addPositionalArgument(u"command"_s, Text::tr("One of the commands above."), u"COMMAND [ARGUMENT…]"_s);
    const auto add = [&parser](const QString &name, const QString &text, const QString &value = {}) {
        parser.addOption(QCommandLineOption(name, text, value));
    };
    add(u"device"_s, Text::tr("The port."), u"PATH|COMn|tcp://HOST:PORT"_s);
    add(u"baud"_s, Text::tr("Speed; 115200 if not given. An ИН-Д3 comes with 9600 from the factory."), u"N"_s);
    add(u"parity"_s, Text::tr("Parity; none if not given."), u"none|even|odd|mark|space"_s);
    add(u"stop-bits"_s, Text::tr("Stop bits; 1 if not given."), u"1|1.5|2"_s);
    add(u"rs485"_s, Text::tr("The driver of the adapter switches the direction (RS485=1 in the ini)."));
    add(u"type"_s, Text::tr("Type of the sensor; needed where both have the command."), u"ind3|and3"_s);
    add(u"protocol"_s, Text::tr("What an ИН-Д3 speaks; 2.11 if not given."), u"2.11|2.10|modbus"_s);
    add(u"address"_s, Text::tr("Address of the sensor, 1…255."), u"N"_s);
    add(u"timeout"_s,
        Text::tr("How long one answer is waited for; 200 if not given. It is asked for up to three times."), u"MS"_s);
    add(u"from"_s, Text::tr("scan: the first address."), u"N"_s);
    add(u"to"_s, Text::tr("scan: the last address."), u"N"_s);
    add(u"count"_s,
        Text::tr(
            "read: how many times; 0: until Ctrl+C. Once if not given. usm records: of the last N only, 1…999; 0 or "
            "not given: of all."),
        u"N"_s);
    add(u"interval"_s, Text::tr("read: from one to the next; 1000 if not given."), u"MS"_s);
    add(u"ticks"_s, Text::tr("set-averaging: ticks."), u"1|2|4|8|16|32|64"_s);
    add(u"period"_s, Text::tr("set-averaging: period in ms. usm start-cycle: 900…43200 s."), u"N"_s);
    add(u"channel"_s, Text::tr("usm value, usm records: 1 is X, 2 is Y."), u"1|2"_s);
    add(u"store"_s, Text::tr("usm value: the device keeps the measurement with the time of now."));
    add(u"mask"_s, Text::tr("usm records: all (if not given), or those not yet read."), u"ALL|NEW"_s);
    add(u"csv"_s, Text::tr("usm records: the table that is written; one that is there is continued, each record once."),
        u"FILE"_s);
    add(u"start-in"_s, Text::tr("usm start-cycle: seconds to the first measurement; 10 if not given."), u"S"_s);
    add(u"delay"_s, Text::tr("usm start-cycle: seconds before each measurement, 0…600; 0 if not given."), u"S"_s);
    add(u"yes"_s, Text::tr("Writes without asking."));
    add(u"json"_s, Text::tr("Prints JSON."));
    add(u"lang"_s, Text::tr("Language of the program."), u"ru|en"_s);
    add(u"help"_s, Text::tr("Prints this."));
    add(u"version"_s, Text::tr("Prints the version."));
}

QStringList commandOptions()
{
    QStringList names;
    for (const Command &command : commands()) {
        names += command.options;
    }
    return names;
}

QStringList withNumbersProtected(QStringList arguments)
{
    static const QRegularExpression negative(u"^-(?=[0-9.,])"_s);
    return arguments.replaceInStrings(negative, QString(QChar(0x2212)));
}

} // namespace gorizont::tool
