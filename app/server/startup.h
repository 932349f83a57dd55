#pragma once

#include "app/server/options.h"
#include "core/config/serverconfig.h"

#include <optional>

namespace gorizont {

/// The configuration that was found and where its data go.
struct Site
{
    ConfigReading reading;
    QString configFile; ///< absolute; of the demonstration: a resource
    QString dataFolder; ///< absolute, exists
};

/// The ini of the command line, else beside the executable, else in the user's configuration folder. Empty: there is none.
QString findConfigFile(const Options &options);

/// Reads \a configFile. Empty: \a problem is a sentence for the user.
std::optional<ConfigReading> loadConfig(const QString &configFile, QString *problem);

/// Reads \a configFile and makes the data folder. Empty: \a problem is a sentence for the user.
std::optional<Site> loadSite(const Options &options, const QString &configFile, QString *problem);

} // namespace gorizont
