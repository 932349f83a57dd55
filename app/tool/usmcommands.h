#pragma once

#include "app/tool/command.h"

/// What gorizont-tool does with an УСМ-ИСН: `gorizont-tool usm …`.
namespace gorizont::tool::usmcommands {

QList<Command> table();

} // namespace gorizont::tool::usmcommands
