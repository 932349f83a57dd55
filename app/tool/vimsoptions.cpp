#include "app/tool/vimsoptions.h"

#include "app/tool/numberoption.h"
#include "app/tool/text.h"

#include <QCommandLineParser>
#include <QUrl>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

constexpr int defaultTimeout = 1000; ///< ms: a network is no shared line, nobody waits behind

QString jsonKeys()
{
    return Text::tr(
        "JSON, one object a line; what is not known is null:\n"
        "  every one   type (L-VIMS), device\n"
        "  info        name, serial, firmware, board, mode (1 boot loader, 2 at work), writeError, settingsError\n"
        "  state       channels: channel (0…3), state (0 good, 1 short circuit, 2 break, 65535 no data), "
        "measurements:\n"
        "              index, type, value, percent, fault, warning, stop, baselineValid, baselineExceeded; relays:\n"
        "              index, logical, physical, error, enabled\n"
        "  waveform    channel, id, samples, rate (Hz), disturbances, file\n"
        "  spectrum    channel, spectrum (5000, 200), bins, rate (Hz), disturbances, peakFrequency (Hz),\n"
        "              peakAmplitude, file\n"
        "  settings    setting (settings), done, file; load: writeError, settingsError; show: values (name: value in\n"
        "              use), differences: name, current, changed; set, apply, flash: changes: name, before, after;\n"
        "              applied, flash, writeError, settingsError\n"
        "  reload, reboot  setting, done; reload: writeError, settingsError\n"
        "  a failure   fault: timeout, checksum, bad reply, refused, closed, cancelled");
}

QString readCommand(const QCommandLineParser &parser, VimsOptions &options)
{
    const QStringList words = parser.positionalArguments();
    const QStringList names{u"info"_s,     u"state"_s,  u"waveform"_s, u"spectrum"_s,
                            u"settings"_s, u"reload"_s, u"reboot"_s};
    const qsizetype at = words.size() == 1 ? names.indexOf(words.constFirst()) : -1;
    if (at < 0) {
        return Text::tr("vims takes one of %1; see gorizont-tool vims --help").arg(names.join(u", "_s));
    }
    options.command = static_cast<VimsOptions::Command>(at);
    return {};
}

/// host, host:port, or tcp:// before either; the port of Modbus if there is none.
QString readDevice(const QCommandLineParser &parser, VimsOptions &options)
{
    constexpr int modbusPort = 502;
    const QString text = parser.value(u"device"_s);
    const QUrl url(text.contains(u"://"_s) ? text : u"tcp://"_s + text);
    if (url.scheme() != u"tcp" || url.host().isEmpty() || url.port(modbusPort) < 1) {
        return Text::tr("--device takes tcp://host:port, not \"%1\"").arg(text);
    }
    options.line.device = u"tcp://%1:%2"_s.arg(url.host()).arg(url.port(modbusPort));
    return {};
}

QString readKind(const QCommandLineParser &parser, VimsOptions &options)
{
    using Kind = lvims::Capture::Kind;
    if (options.command != VimsOptions::Command::Spectrum) {
        return {};
    }
    const QString type = parser.isSet(u"type"_s) ? parser.value(u"type"_s) : u"5000"_s;
    options.kind = type == u"200" ? Kind::Spectrum200 : Kind::Spectrum5000;
    return type == u"200" || type == u"5000" ? QString() : Text::tr("--type takes 5000 or 200, not \"%1\"").arg(type);
}

/// Values are tried on settings that are all 0, so that a wrong one is told before the module is asked.
QString readChanges(const QCommandLineParser &parser, VimsOptions &options)
{
    QList<quint16> image(lvims::settingsSize, 0);
    for (const QString &text : parser.values(u"set"_s)) {
        const qsizetype equals = text.indexOf(u'=');
        const lvims::Setting *setting = equals > 0 ? lvims::settingNamed(text.left(equals)) : nullptr;
        if (!setting) {
            return Text::tr("--set takes NAME=VALUE with a name that --show prints, not \"%1\"").arg(text);
        }
        const QString value = text.mid(equals + 1);
        if (const QString problem = lvims::change(image, *setting, value); !problem.isEmpty()) {
            return problem;
        }
        options.changes.append({*setting, value});
    }
    return {};
}

QString readSettings(const QCommandLineParser &parser, VimsOptions &options)
{
    options.out = parser.value(u"out"_s);
    options.saveTo = parser.value(u"save"_s);
    options.loadFrom = parser.value(u"load"_s);
    options.shows = parser.isSet(u"show"_s);
    options.applies = parser.isSet(u"apply"_s);
    options.toFlash = parser.isSet(u"flash"_s);
    if (options.command != VimsOptions::Command::Settings) {
        return {};
    }
    if (const QString problem = readChanges(parser, options); !problem.isEmpty()) {
        return problem;
    }
    const bool isLoad = !options.loadFrom.isEmpty();
    const bool changes = !options.changes.isEmpty() || (!isLoad && (options.applies || options.toFlash));
    const int wanted = int(!options.saveTo.isEmpty()) + int(isLoad) + int(options.shows) + int(changes);
    return wanted == 1
        ? QString()
        : Text::tr("vims settings takes one of --show, --save FILE, --load FILE and --set NAME=VALUE, the "
                   "last with --apply and --flash, which may stand alone");
}

} // namespace

void describeVims(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        Text::tr("Reads an L-VIMS vibration module over the network; others may read it meanwhile.") + u"\n\n"_s
        + Text::tr("info       prints what the module is\n"
                   "state      prints what it measures, and its relays\n"
                   "waveform   lets it keep a waveform, fetches it and writes it to --out\n"
                   "spectrum   the same for its spectrum up to 5000 Hz or 200 Hz\n"
                   "settings   shows its settings, changes single ones, or writes them to a file and back\n"
                   "reload     lets it use the settings of its flash again\n"
                   "reboot     restarts it")
        + u"\n\n"_s
        + Text::tr("A .csv has the columns time (s), code and value, or frequency (Hz) and amplitude. A .wav is scaled "
                   "so that its largest value is 1.")
        + u"\n\n"_s
        + Text::tr("Exit codes: 0 done; 1 refused by the module or by the user; 2 the command line is wrong; 3 no "
                   "answer, or no connection.")
        + u"\n\n"_s + jsonKeys());
    parser.addPositionalArgument(u"command"_s, Text::tr("One of the commands above."), u"COMMAND"_s);
    parser.addOptions({
        {u"device"_s, Text::tr("The module; port 502 if none is given."), u"tcp://host:port"_s},
        {QStringList{u"unit"_s, u"address"_s}, Text::tr("Unit of Modbus; 1 if not given."), u"N"_s},
        {u"timeout"_s, Text::tr("How long one answer is waited for; %1 if not given.").arg(defaultTimeout), u"MS"_s},
        {u"channel"_s, Text::tr("waveform, spectrum: 0…3; 0 if not given."), u"N"_s},
        {u"type"_s, Text::tr("spectrum: up to 5000 (if not given) or 200 Hz."), u"5000|200"_s},
        {u"out"_s, Text::tr("waveform, spectrum: the file, .csv or, of a waveform, .wav."), u"FILE"_s},
        {u"save"_s, Text::tr("settings: writes them to this file."), u"FILE"_s},
        {u"load"_s, Text::tr("settings: writes this file to the module and lets it use them."), u"FILE"_s},
        {u"show"_s, Text::tr("settings: prints those in use, and those prepared where they differ.")},
        {u"set"_s,
         Text::tr("settings: prepares one, such as CH1.SENSOR_K=100 or CH0.MEAS3.IIR_LP.FC=200.5; may be repeated."),
         u"NAME=VALUE"_s},
        {u"apply"_s, Text::tr("settings: lets the module use those prepared.")},
        {u"flash"_s, Text::tr("settings: keeps them for the next start of the module too.")},
        {u"yes"_s, Text::tr("Writes without asking.")},
        {u"json"_s, Text::tr("Prints JSON.")},
        {u"lang"_s, Text::tr("Language of the program."), u"ru|en"_s},
        {u"help"_s, Text::tr("Prints this.")},
    });
}

std::variant<VimsOptions, QString> vimsOptions(const QCommandLineParser &parser)
{
    VimsOptions options;
    int timeout = defaultTimeout;
    QStringList problems{
        readCommand(parser, options),
        readDevice(parser, options),
        readNumber(parser, u"unit"_s, 0, 255, options.address.unit),
        readNumber(parser, u"timeout"_s, 1, 60'000, timeout),
        readNumber(parser, u"channel"_s, 0, lvims::channelCount - 1, options.channel),
        readKind(parser, options),
        readSettings(parser, options)};
    options.timing.readCommand = std::chrono::milliseconds(timeout);
    options.isYes = parser.isSet(u"yes"_s);
    options.isJson = parser.isSet(u"json"_s);
    problems.removeAll(QString());
    if (!problems.isEmpty()) {
        return problems.constFirst();
    }
    return options;
}

} // namespace gorizont::tool
