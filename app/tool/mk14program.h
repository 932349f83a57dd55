#pragma once

#include "app/tool/command.h"

namespace gorizont::tool {

/// `gorizont-tool mk14 …`: the weather station МК-14; `--help` lists what it can do.
ExitCode runMk14(const QStringList &arguments);

} // namespace gorizont::tool
