#pragma once

#include "app/tool/command.h"

class QCommandLineParser;

namespace gorizont::tool {

/// Tells \a parser of `gorizont-tool archive` the options that only an import needs.
void describeImport(QCommandLineParser &parser);

/// `gorizont-tool archive import-history \a folder`: what old files hold goes into the archive of a configuration.
ExitCode importHistory(const QCommandLineParser &parser, const QString &folder);

} // namespace gorizont::tool
