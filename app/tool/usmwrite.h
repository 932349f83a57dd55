#pragma once

#include "app/tool/command.h"

/// The commands of gorizont-tool that change something in an УСМ-ИСН.
namespace gorizont::tool::usmwrite {

ExitCode startCycle(Session &session);
ExitCode stopCycle(Session &session);
ExitCode setAddress(Session &session);
ExitCode portSettings(Session &session);

} // namespace gorizont::tool::usmwrite
