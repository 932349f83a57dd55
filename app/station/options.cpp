#include "app/station/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::StationOptions)
};

void addOptions(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        Text::tr("A weather station: measures, corrects, averages, keeps records and answers dispatchers.\n\n"
                 "SIGHUP reads the files of the station again, SIGINT and SIGTERM end the program."));
    const auto add = [&parser](const QString &name, const QString &text, const QString &value = {}) {
        parser.addOption(QCommandLineOption(name, text, value));
    };
    add(u"config"_s, Text::tr("The folder with ACK.INI and the other files of the station."), u"DIR"_s);
    add(u"data"_s, Text::tr("Where records and the log go; default: the folder of the configuration."), u"DIR"_s);
    add(u"ports"_s, Text::tr("Port number n is opened as DIR/COMn."), u"DIR"_s);
    add(u"listen"_s,
        Text::tr(
            "Waits for dispatchers over TCP too: PORT for this computer only, ADDRESS:PORT for others. May be given "
            "several times."),
        u"[ADDRESS:]PORT"_s);
    add(u"headless"_s, Text::tr("Without effect: the station never has a window."));
    add(u"print"_s, Text::tr("Prints every second as one line of JSON."));
    add(u"set-clock"_s,
        Text::tr("A dispatcher may set the clock of this computer; else the station keeps a clock of its own."));
    add(u"lang"_s, Text::tr("Language of the program."), u"ru|en"_s);
    add(u"help"_s, Text::tr("Prints this."));
    add(u"version"_s, Text::tr("Prints the version."));
}

/// A sentence for the first thing that cannot be; empty when all is well.
QString usageProblem(const QCommandLineParser &parser)
{
    if (!parser.positionalArguments().isEmpty()) {
        return Text::tr("Unexpected argument: %1").arg(parser.positionalArguments().constFirst());
    }
    if (!parser.isSet(u"config"_s)) {
        return Text::tr("--config DIR is needed, the folder with ACK.INI and the other files of the station");
    }
    const QString language = parser.value(u"lang"_s);
    if (parser.isSet(u"lang"_s) && language != u"ru" && language != u"en") {
        return Text::tr("--lang takes ru or en, not %1").arg(language);
    }
    for (const QString &place : parser.values(u"listen"_s)) {
        if (!station::ListenAddress::from(place)) {
            return Text::tr("--listen takes PORT or ADDRESS:PORT, with an address in digits, not %1").arg(place);
        }
    }
    return {};
}

} // namespace

std::variant<StationOptions, StationLastWords> parseStationOptions(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(arguments)) {
        return StationLastWords{StationUsage, parser.errorText()};
    }
    if (parser.isSet(u"help"_s)) {
        return StationLastWords{StationGood, parser.helpText()};
    }
    if (parser.isSet(u"version"_s)) {
        return StationLastWords{StationGood, QStringLiteral("gorizont-station " GORIZONT_VERSION)};
    }
    if (const QString problem = usageProblem(parser); !problem.isEmpty()) {
        return StationLastWords{StationUsage, problem};
    }
    StationOptions options;
    options.configFolder = QDir(parser.value(u"config"_s)).absolutePath();
    options.dataFolder = parser.isSet(u"data"_s) ? QDir(parser.value(u"data"_s)).absolutePath() : options.configFolder;
    // Absolute, because a relative name of a port means one below /dev.
    if (parser.isSet(u"ports"_s)) {
        options.portsFolder = QDir(parser.value(u"ports"_s)).absolutePath();
    }
    options.language = parser.value(u"lang"_s);
    for (const QString &place : parser.values(u"listen"_s)) {
        options.listen.append(*station::ListenAddress::from(place));
    }
    options.prints = parser.isSet(u"print"_s);
    options.maySetClock = parser.isSet(u"set-clock"_s);
    return options;
}

QString stationLanguage(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    parser.parse(arguments);
    return parser.value(u"lang"_s);
}

} // namespace gorizont
