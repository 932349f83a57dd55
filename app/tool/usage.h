#pragma once

#include <QStringList>

class QCommandLineParser;

namespace gorizont::tool {

/// Tells \a parser every option with its help, and the commands, exit codes and JSON keys.
void describeUsage(QCommandLineParser &parser);

/// The options that belong to some commands only.
QStringList commandOptions();

/// A minus in front of a number does not make it an option: it becomes the typographic one, which no option begins with.
QStringList withNumbersProtected(QStringList arguments);

} // namespace gorizont::tool
