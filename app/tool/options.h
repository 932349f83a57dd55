#pragma once

#include "app/tool/command.h"
#include "app/tool/usmoptions.h"
#include "core/devices/ind3/ind3dialect.h"
#include "core/values/lineconfig.h"
#include "core/values/reading.h"
#include "core/values/timing.h"

#include <optional>
#include <variant>

namespace gorizont::tool {

/// The command line of gorizont-tool: a contract for scripts. Everything in it is within its range.
struct Options
{
    const Command *command = nullptr;
    Device device = Device::Ind3;
    LineConfig line; ///< --device, --baud, --parity, --stop-bits, --rs485
    ind3::Dialect dialect = ind3::Dialect::V211; ///< --protocol
    int address = 0; ///< --address; 0: the command needs none
    Timing timing; ///< --timeout
    bool isJson = false;
    bool isYes = false; ///< writes without asking

    int from = 1; ///< of scan
    int to = 255;
    int count = 1; ///< of read; 0: until Ctrl+C
    std::chrono::milliseconds interval{1000};

    int newAddress = 0; ///< of set-address
    QString name; ///< of set-name
    Tilt offset; ///< of set-offset, arc-seconds
    std::optional<int> ticks; ///< of set-averaging
    std::optional<std::chrono::milliseconds> period;

    UsmOptions usm; ///< of the commands of УСМ-ИСН
};

/// What there is to say before the program ends: help, version, or a usage error.
struct LastWords
{
    ExitCode exitCode = ExitGood;
    QString text;
};

std::variant<Options, LastWords> parseOptions(const QStringList &arguments);

/// The value of --lang before anything else can be read.
QString languageArgument(const QStringList &arguments);

} // namespace gorizont::tool
