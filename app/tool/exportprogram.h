#pragma once

#include "app/tool/command.h"

#include <QStringList>

namespace gorizont::tool {

/// `gorizont-tool export …`: what an archive holds to a file. The server may run meanwhile.
/// \a arguments: behind the word `export`.
ExitCode runExportProgram(const QStringList &arguments);

} // namespace gorizont::tool
