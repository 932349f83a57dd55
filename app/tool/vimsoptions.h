#pragma once

#include "app/tool/command.h"
#include "core/devices/lvims/lvimsservice.h"
#include "core/values/lineconfig.h"

#include <variant>

class QCommandLineParser;

namespace gorizont::tool {

/// The command line of `gorizont-tool vims`. Everything in it is within its range.
struct VimsOptions
{
    enum class Command : quint8 { Info, State, Waveform, Spectrum, Settings, Reload, Reboot };

    Command command = Command::Info;
    LineConfig line; ///< --device
    lvims::Address address; ///< --unit
    Timing timing; ///< --timeout
    int channel = 0; ///< 0…3
    lvims::Capture::Kind kind = lvims::Capture::Kind::Waveform; ///< of waveform and spectrum
    QString out; ///< of waveform and spectrum; empty: nothing is written
    /// Of settings: one of these four is given.
    QString saveTo;
    QString loadFrom;
    bool shows = false;
    QList<std::pair<lvims::Setting, QString>> changes; ///< --set, each of which its setting takes; or only what follows
    bool applies = false; ///< of settings: lets the module use those prepared
    bool toFlash = false; ///< of settings
    bool isYes = false; ///< writes without asking
    bool isJson = false;
};

void describeVims(QCommandLineParser &parser);

/// What is wrong as a sentence, or the options.
std::variant<VimsOptions, QString> vimsOptions(const QCommandLineParser &parser);

} // namespace gorizont::tool
