#pragma once

#include "app/tool/command.h"

namespace gorizont::tool {

/// `gorizont-tool archive …`: needs no sensor and no port. \a arguments: what follows the word archive.
ExitCode runArchive(const QStringList &arguments);

} // namespace gorizont::tool
