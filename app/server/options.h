#pragma once

#include <QString>
#include <QStringList>

#include <variant>

namespace gorizont {

/// The command line of gorizont-server: a contract for scripts.
struct Options
{
    QString configFile; ///< --config; empty: looked for
    QString dataFolder; ///< --data; empty: the folder of the ini
    QString portsFolder; ///< --ports: port n is DIR/COMn
    QString language; ///< --lang: `ru`, `en`; empty: the ini decides
    bool isHeadless = false;
    bool isDemo = false;
    bool printsReadings = false;
    bool printsRegisterMap = false; ///< nothing but that; headless is set too
    bool printsOpcTags = false; ///< nothing but that; headless is set too
};

/// What there is to say before the program ends: help, version, or a usage error.
struct LastWords
{
    int exitCode = 0;
    QString text;
};

/// Exit codes of gorizont-server.
enum ExitCode { ExitGood = 0, ExitFailed = 1, ExitUsage = 2, ExitSecondCopy = 3 };

std::variant<Options, LastWords> parseOptions(const QStringList &arguments);

/// The value of --lang or --headless before anything else can be read.
QString languageArgument(const QStringList &arguments);

} // namespace gorizont
