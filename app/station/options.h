#pragma once

#include "core/station/service/doors.h"

#include <QStringList>

#include <variant>

namespace gorizont {

/// The command line of gorizont-station: a contract for scripts.
struct StationOptions
{
    QString configFolder; ///< --config
    QString dataFolder; ///< --data; empty: the folder of the configuration
    QString portsFolder; ///< --ports: port n is DIR/COMn
    QString language; ///< --lang: `ru`, `en`; empty: ru
    QList<station::ListenAddress> listen; ///< --listen, any number
    bool prints = false; ///< --print
    bool maySetClock = false; ///< --set-clock
};

/// Exit codes of gorizont-station.
enum StationExitCode { StationGood = 0, StationFailed = 1, StationUsage = 2, StationSecondCopy = 3 };

/// What there is to say before the program ends: help, version, or a usage error.
struct StationLastWords
{
    int exitCode = StationGood;
    QString text;
};

std::variant<StationOptions, StationLastWords> parseStationOptions(const QStringList &arguments);

/// The value of --lang before anything else can be read.
QString stationLanguage(const QStringList &arguments);

} // namespace gorizont
