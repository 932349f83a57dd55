#include "app/server/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>

namespace gorizont {

namespace {

class OptionsText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Options)
};

void addOptions(QCommandLineParser &parser)
{
    using Qt::Literals::StringLiterals::operator""_s;
    parser.setApplicationDescription(
        OptionsText::tr("Polls inclinometers and accelerometers, shows, saves and serves their readings."));
    const auto add = [&parser](const QString &name, const QString &text, const QString &value = {}) {
        parser.addOption(QCommandLineOption(name, text, value));
    };
    add(u"config"_s, OptionsText::tr("The configuration, GorizontServer.ini."), u"FILE"_s);
    add(u"data"_s, OptionsText::tr("Where History goes; default: the folder of the ini."), u"DIR"_s);
    add(u"ports"_s, OptionsText::tr("Port number n is opened as DIR/COMn."), u"DIR"_s);
    add(u"headless"_s, OptionsText::tr("No window; ends on SIGINT or SIGTERM."));
    add(u"demo"_s, OptionsText::tr("A simulated building, no files to prepare."));
    add(u"lang"_s, OptionsText::tr("Language of the program."), u"ru|en"_s);
    add(u"print-readings"_s, OptionsText::tr("Prints each new reading as one line of JSON."));
    add(u"print-register-map"_s, OptionsText::tr("Prints the Modbus registers of the configuration as Markdown."));
    add(u"print-opc-tags"_s, OptionsText::tr("Prints the tags of OPC DA: name, type and description, parted by tabs."));
    add(u"help"_s, OptionsText::tr("Prints this."));
    add(u"version"_s, OptionsText::tr("Prints the version."));
}

/// A sentence for the first thing that cannot be; empty when all is well.
QString usageProblem(const QCommandLineParser &parser)
{
    if (!parser.positionalArguments().isEmpty()) {
        return OptionsText::tr("Unexpected argument: %1").arg(parser.positionalArguments().constFirst());
    }
    const QString language = parser.value(QStringLiteral("lang"));
    if (parser.isSet(QStringLiteral("lang")) && language != QStringLiteral("ru") && language != QStringLiteral("en")) {
        return OptionsText::tr("--lang takes ru or en, not %1").arg(language);
    }
    if (parser.isSet(QStringLiteral("demo")) && parser.isSet(QStringLiteral("config"))) {
        return OptionsText::tr("--demo brings its own configuration; leave --config away");
    }
    return {};
}

} // namespace

std::variant<Options, LastWords> parseOptions(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(arguments)) {
        return LastWords{ExitUsage, parser.errorText()};
    }
    if (parser.isSet(QStringLiteral("help"))) {
        return LastWords{ExitGood, parser.helpText()};
    }
    if (parser.isSet(QStringLiteral("version"))) {
        return LastWords{ExitGood, QStringLiteral("gorizont-server " GORIZONT_VERSION)};
    }
    if (const QString problem = usageProblem(parser); !problem.isEmpty()) {
        return LastWords{ExitUsage, problem};
    }
    Options options;
    options.configFile = parser.value(QStringLiteral("config"));
    options.dataFolder = parser.value(QStringLiteral("data"));
    // Absolute, because a relative name of a port means one below /dev.
    if (parser.isSet(QStringLiteral("ports"))) {
        options.portsFolder = QDir(parser.value(QStringLiteral("ports"))).absolutePath();
    }
    options.language = parser.value(QStringLiteral("lang"));
    options.printsRegisterMap = parser.isSet(QStringLiteral("print-register-map"));
    options.printsOpcTags = parser.isSet(QStringLiteral("print-opc-tags"));
    options.isHeadless = options.printsRegisterMap || options.printsOpcTags || parser.isSet(QStringLiteral("headless"));
    options.isDemo = parser.isSet(QStringLiteral("demo"));
    options.printsReadings = parser.isSet(QStringLiteral("print-readings"));
    return options;
}

QString languageArgument(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    parser.parse(arguments);
    return parser.value(QStringLiteral("lang"));
}

} // namespace gorizont
