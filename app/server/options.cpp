#include "app/server/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>

namespace gorizont {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("gorizont::Options", text);
}

void addOptions(QCommandLineParser &parser)
{
    using Qt::Literals::StringLiterals::operator""_s;
    parser.setApplicationDescription(tr(QT_TRANSLATE_NOOP(
        "gorizont::Options", "Polls inclinometers and accelerometers, shows, saves and serves their readings.")));
    const auto add = [&parser](const QString &name, const char *text, const QString &value = {}) {
        parser.addOption(QCommandLineOption(name, tr(text), value));
    };
    add(u"config"_s, QT_TRANSLATE_NOOP("gorizont::Options", "The configuration, GorizontServer.ini."), u"FILE"_s);
    add(u"data"_s, QT_TRANSLATE_NOOP("gorizont::Options", "Where History goes; default: the folder of the ini."),
        u"DIR"_s);
    add(u"ports"_s, QT_TRANSLATE_NOOP("gorizont::Options", "Port number n is opened as DIR/COMn."), u"DIR"_s);
    add(u"headless"_s, QT_TRANSLATE_NOOP("gorizont::Options", "No window; ends on SIGINT or SIGTERM."));
    add(u"demo"_s, QT_TRANSLATE_NOOP("gorizont::Options", "A simulated building, no files to prepare."));
    add(u"lang"_s, QT_TRANSLATE_NOOP("gorizont::Options", "Language of the program."), u"ru|en"_s);
    add(u"print-readings"_s, QT_TRANSLATE_NOOP("gorizont::Options", "Prints each new reading as one line of JSON."));
    add(u"help"_s, QT_TRANSLATE_NOOP("gorizont::Options", "Prints this."));
    add(u"version"_s, QT_TRANSLATE_NOOP("gorizont::Options", "Prints the version."));
}

/// A sentence for the first thing that cannot be; empty when all is well.
QString usageProblem(const QCommandLineParser &parser)
{
    if (!parser.positionalArguments().isEmpty()) {
        return tr(QT_TRANSLATE_NOOP("gorizont::Options", "Unexpected argument: %1"))
            .arg(parser.positionalArguments().constFirst());
    }
    const QString language = parser.value(QStringLiteral("lang"));
    if (parser.isSet(QStringLiteral("lang")) && language != QStringLiteral("ru") && language != QStringLiteral("en")) {
        return tr(QT_TRANSLATE_NOOP("gorizont::Options", "--lang takes ru or en, not %1")).arg(language);
    }
    if (parser.isSet(QStringLiteral("demo")) && parser.isSet(QStringLiteral("config"))) {
        return tr(QT_TRANSLATE_NOOP("gorizont::Options", "--demo brings its own configuration; leave --config away"));
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
    options.portsFolder = parser.value(QStringLiteral("ports"));
    options.language = parser.value(QStringLiteral("lang"));
    options.isHeadless = parser.isSet(QStringLiteral("headless"));
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
