#pragma once

#include "app/tool/command.h"
#include "core/devices/mk14/mk14options.h"
#include "core/values/lineconfig.h"
#include "core/values/timing.h"

#include <variant>

class QCommandLineParser;

namespace gorizont::tool {

/// The command line of `gorizont-tool mk14`. Everything in it is within its range.
struct Mk14Options
{
    enum class Command : quint8 { Read, SetTime, SetOutputs, SendFile };

    Command command = Command::Read;
    LineConfig line; ///< --device, --baud, --data-bits, --parity, --stop-bits, --rs485
    int address = 1; ///< --address
    Timing timing; ///< --timeout
    mk14::Options station; ///< --params, --par-file, --outputs, --utc
    int dataCommand = 4; ///< --cmd, of read
    quint32 word = 0; ///< of set-outputs
    QString file; ///< of send-file
    QString name; ///< under which the station gets it
    bool isYes = false; ///< sends without asking
    bool isJson = false;
};

void describeMk14(QCommandLineParser &parser);

/// What is wrong as a sentence, or the options.
std::variant<Mk14Options, QString> mk14Options(const QCommandLineParser &parser);

} // namespace gorizont::tool
