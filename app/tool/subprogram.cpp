#include "app/tool/subprogram.h"

#include "app/tool/output.h"

#include <QCommandLineParser>

namespace gorizont::tool {

std::optional<ExitCode> parseSubprogram(QCommandLineParser &parser, const QString &name, const QStringList &arguments)
{
    if (!parser.parse(QStringList{QStringLiteral("gorizont-tool ") + name} + arguments)) {
        complain(parser.errorText());
        return ExitUsage;
    }
    if (parser.isSet(QStringLiteral("help"))) {
        print(parser.helpText().trimmed());
        return ExitGood;
    }
    return {};
}

} // namespace gorizont::tool
