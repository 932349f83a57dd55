#include "app/tool/mk14options.h"

#include "app/tool/numberoption.h"
#include "app/tool/text.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

constexpr int defaultTimeout = 1000; ///< ms
constexpr int defaultBaud = 9600;

QString jsonKeys()
{
    return Text::tr(
        "JSON, one object a line; what the station did not send, or sent as not valid, is absent:\n"
        "  every one   type (MK-14), device, address\n"
        "  read        cmd, digital, parameters: code, number, name, unit, mean, instant, min, max, voltage,\n"
        "              voltageInstant, maxPeriod, deviation; events: start, time (s)\n"
        "  set-…,      setting (time, outputs, file), done; time: seconds since 1970 that were sent; outputs, "
        "digital;\n"
        "  send-file   file, name\n"
        "  a failure   fault: timeout, checksum, bad reply, refused, closed, cancelled");
}

QString readCommand(const QCommandLineParser &parser, Mk14Options &options)
{
    const QStringList words = parser.positionalArguments();
    const QStringList names{u"read"_s, u"set-time"_s, u"set-outputs"_s, u"send-file"_s};
    const qsizetype at = words.isEmpty() ? -1 : names.indexOf(words.constFirst());
    if (at < 0) {
        return Text::tr("mk14 takes one of %1; see gorizont-tool mk14 --help").arg(names.join(u", "_s));
    }
    options.command = static_cast<Mk14Options::Command>(at);
    const bool needsMore = at >= int(Mk14Options::Command::SetOutputs);
    if (words.size() != (needsMore ? 2 : 1)) {
        return Text::tr("after %1 comes %2")
            .arg(
                words.constFirst(),
                at == 2       ? u"WORD"_s
                    : at == 3 ? u"FILE"_s
                              : Text::tr("nothing"));
    }
    if (options.command == Mk14Options::Command::SetOutputs) {
        const auto word = mk14::outputWord(words.at(1));
        options.word = word.value_or(0);
        return word ? QString() : Text::tr("outputs are a number like 5 or 0x0005, not \"%1\"").arg(words.at(1));
    }
    options.file = words.value(1);
    options.name = parser.isSet(u"name"_s) ? parser.value(u"name"_s) : QFileInfo(options.file).fileName();
    return {};
}

QString readDevice(const QCommandLineParser &parser, Mk14Options &options)
{
    static const QRegularExpression numbered(u"^com([1-9][0-9]{0,3})$"_s, QRegularExpression::CaseInsensitiveOption);
    const QString device = parser.value(u"device"_s);
    const QUrl url(device);
    const bool isTcp = url.scheme() == u"tcp";
    if (device.isEmpty() || (isTcp && (url.host().isEmpty() || url.port(0) < 1)) || url.scheme() == u"sim") {
        return Text::tr("--%1 takes %2, not \"%3\"").arg(u"device"_s, u"PATH, COMn, tcp://HOST:PORT"_s, device);
    }
    if (const auto match = numbered.match(device); match.hasMatch()) {
        options.line.com = match.captured(1).toInt();
    } else {
        // A relative name means one below /dev.
        options.line.device = !isTcp && device.contains(u'/') ? QDir(device).absolutePath() : device;
    }
    return {};
}

/// The one of \a names that \a option has, counted from 0; −1: none of them.
qsizetype choice(const QCommandLineParser &parser, const QString &option, const QStringList &names)
{
    return parser.isSet(option) ? names.indexOf(parser.value(option)) : 0;
}

QString readPort(const QCommandLineParser &parser, Mk14Options &options)
{
    LineConfig &line = options.line;
    line.baudRate = defaultBaud;
    const QStringList parities{u"none"_s, u"even"_s, u"odd"_s, u"mark"_s, u"space"_s};
    const QStringList stopBits{u"1"_s, u"1.5"_s, u"2"_s};
    const qsizetype parity = choice(parser, u"parity"_s, parities);
    const qsizetype stop = choice(parser, u"stop-bits"_s, stopBits);
    if (parity < 0 || stop < 0) {
        const QString option = parity < 0 ? u"parity"_s : u"stop-bits"_s;
        return Text::tr("--%1 takes %2, not \"%3\"")
            .arg(option, (parity < 0 ? parities : stopBits).join(u", "_s), parser.value(option));
    }
    line.parity = static_cast<Parity>(parity);
    line.stopBits = static_cast<StopBits>(stop);
    line.isRs485 = parser.isSet(u"rs485"_s);
    const QString problem = readNumber(parser, u"data-bits"_s, 5, 8, line.dataBits);
    return problem.isEmpty() ? readNumber(parser, u"baud"_s, 50, 4'000'000, line.baudRate) : problem;
}

/// The same keys as in the ini.
QString readStation(const QCommandLineParser &parser, Mk14Options &options)
{
    SensorConfig sensor;
    sensor.options.insert(u"params"_s, parser.value(u"params"_s));
    sensor.options.insert(u"parfile"_s, parser.value(u"par-file"_s));
    sensor.options.insert(u"stationclock"_s, parser.isSet(u"utc"_s) ? u"UTC"_s : QString());
    options.station = mk14::Options::from(sensor);
    const QString outputs = parser.value(u"outputs"_s);
    const auto word = outputs.isEmpty() ? std::optional<quint32>(0) : mk14::outputWord(outputs);
    if (!word) {
        return Text::tr("outputs are a number like 5 or 0x0005, not \"%1\"").arg(outputs);
    }
    options.station.outputs = *word;
    return options.station.complaints.value(0);
}

} // namespace

void describeMk14(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        Text::tr("Reads and sets a weather station МК-14. The line must not be open in another program.") + u"\n\n"_s
        + Text::tr("read         prints what it measures, by --cmd\n"
                   "set-time     sets its clock to that of this computer\n"
                   "set-outputs  gives its outputs the control word WORD, like 5 or 0x0005\n"
                   "send-file    sends it a settings file like ACK.PAR")
        + u"\n\n"_s
        + Text::tr("Every question carries the control word of the outputs: give read the one that shall stay with "
                   "--outputs. A server that polls the station repeats its own, Outputs{i} of the ini.")
        + u"\n\n"_s
        + Text::tr("Exit codes: 0 done; 1 refused by the user, or impossible; 2 the command line is wrong; 3 no "
                   "answer, not confirmed, or the port cannot be opened.")
        + u"\n\n"_s + jsonKeys());
    parser.addPositionalArgument(u"command"_s, Text::tr("One of the commands above."), u"COMMAND [WORD|FILE]"_s);
    parser.addOptions({
        {u"device"_s, Text::tr("The port."), u"PATH|COMn|tcp://HOST:PORT"_s},
        {u"baud"_s, Text::tr("Speed; %1 if not given.").arg(defaultBaud), u"N"_s},
        {u"data-bits"_s, Text::tr("Data bits; 8 if not given."), u"5…8"_s},
        {u"parity"_s, Text::tr("Parity; none if not given."), u"none|even|odd|mark|space"_s},
        {u"stop-bits"_s, Text::tr("Stop bits; 1 if not given."), u"1|1.5|2"_s},
        {u"rs485"_s, Text::tr("The driver of the adapter switches the direction (RS485=1 in the ini).")},
        {u"address"_s, Text::tr("Address of the station, 1…255; 1 if not given."), u"N"_s},
        {u"timeout"_s, Text::tr("How long one answer is waited for; %1 if not given.").arg(defaultTimeout), u"MS"_s},
        {u"cmd"_s, Text::tr("read: data command, 1…8; 4 if not given."), u"N"_s},
        {u"params"_s, Text::tr("Codes of its parameters in order; U,T,P,H,A,M if not given."), u"LIST"_s},
        {u"par-file"_s, Text::tr("Its ACK.PAR file, which has their codes, names and units."), u"FILE"_s},
        {u"outputs"_s, Text::tr("read: control word of the outputs; 0 if not given."), u"WORD"_s},
        {u"utc"_s, Text::tr("set-time: the clock of the station shows UTC, not local time.")},
        {u"name"_s, Text::tr("send-file: the name that the station gets; that of the file if not given."), u"NAME"_s},
        {u"yes"_s, Text::tr("Writes without asking.")},
        {u"json"_s, Text::tr("Prints JSON.")},
        {u"lang"_s, Text::tr("Language of the program."), u"ru|en"_s},
        {u"help"_s, Text::tr("Prints this.")},
    });
}

std::variant<Mk14Options, QString> mk14Options(const QCommandLineParser &parser)
{
    Mk14Options options;
    int timeout = defaultTimeout;
    QStringList problems{
        readCommand(parser, options),
        readDevice(parser, options),
        readPort(parser, options),
        readNumber(parser, u"address"_s, 1, 255, options.address),
        readNumber(parser, u"timeout"_s, 1, 60'000, timeout),
        readNumber(parser, u"cmd"_s, 1, 8, options.dataCommand),
        readStation(parser, options)};
    options.timing.readCommand = std::chrono::milliseconds(timeout);
    options.timing.readData = std::max(options.timing.readData, options.timing.readCommand);
    options.isYes = parser.isSet(u"yes"_s);
    options.isJson = parser.isSet(u"json"_s);
    problems.removeAll(QString());
    if (!problems.isEmpty()) {
        return problems.constFirst();
    }
    return options;
}

} // namespace gorizont::tool
