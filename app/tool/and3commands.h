#pragma once

#include "app/tool/command.h"

/// What gorizont-tool does with an АН-Д3.
namespace gorizont::tool::and3commands {

ExitCode scan(Session &session);
ExitCode read(Session &session);
ExitCode info(Session &session);
ExitCode setAddress(Session &session);
ExitCode reset(Session &session);

} // namespace gorizont::tool::and3commands
