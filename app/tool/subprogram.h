#pragma once

#include "app/tool/command.h"

#include <optional>

class QCommandLineParser;

namespace gorizont::tool {

/// Reads the \a arguments of `gorizont-tool NAME …`. Not empty: --help was answered or the mistake was told, end with that.
std::optional<ExitCode> parseSubprogram(QCommandLineParser &parser, const QString &name, const QStringList &arguments);

} // namespace gorizont::tool
