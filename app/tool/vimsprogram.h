#pragma once

#include "app/tool/command.h"

namespace gorizont::tool {

/// `gorizont-tool vims …`: the L-VIMS vibration module; `--help` lists what it can do.
ExitCode runVims(const QStringList &arguments);

} // namespace gorizont::tool
