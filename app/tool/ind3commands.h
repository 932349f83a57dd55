#pragma once

#include "app/tool/command.h"

/// What gorizont-tool does with an ИН-Д3.
namespace gorizont::tool::ind3commands {

ExitCode scan(Session &session);
ExitCode read(Session &session);
ExitCode info(Session &session);
ExitCode setAddress(Session &session);
ExitCode setName(Session &session);
ExitCode setOffset(Session &session);
ExitCode setAveraging(Session &session);

} // namespace gorizont::tool::ind3commands
