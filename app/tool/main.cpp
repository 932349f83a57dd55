#include "app/tool/archivecommand.h"
#include "app/tool/exportprogram.h"
#include "app/tool/interruption.h"
#include "app/tool/mk14program.h"
#include "app/tool/options.h"
#include "app/tool/output.h"
#include "app/tool/session.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "app/tool/vimsprogram.h"
#include "core/line/openline.h"
#include "translations/translation.h"

#include <QCoreApplication>

#include <cstdio>

using namespace gorizont;
using namespace gorizont::tool;

namespace {

int sayLastWords(const LastWords &words)
{
    if (words.exitCode == ExitGood) {
        print(words.text.trimmed());
    } else {
        complain(words.text.trimmed());
    }
    return words.exitCode;
}

ExitCode run(const Options &options)
{
    const auto line = makeLine(options.line, {}, options.timing.pauseTick);
    const Interruption interruption(*line);
    Session session(options, *line);
    if (options.command->writes && !options.isYes && !isInputTerminal()) {
        return session.fail(
            Fault::Cancelled,
            Text::tr("there is no terminal to ask at; nothing was written. --yes writes without asking"),
            session.object(options.address));
    }
    if (const auto opened = line->open(); !opened) {
        const QString name = deviceName(options.line, {});
        return session.fail(
            opened.fault(), QStringLiteral("%1: %2").arg(name, line->lastError().text),
            session.object(options.address));
    }
    return options.command->runOf(options.device)(session);
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("gorizont-tool"));
    QCoreApplication::setApplicationVersion(QStringLiteral(GORIZONT_VERSION));
    const QStringList arguments = QCoreApplication::arguments();
    installTranslation(languageArgument(arguments));
    if (arguments.value(1) == u"archive") {
        return runArchive(arguments.mid(2));
    }
    if (arguments.value(1) == u"export") {
        return runExportProgram(arguments.mid(2));
    }
    if (arguments.value(1) == u"mk14") {
        return runMk14(arguments.mid(2));
    }
    if (arguments.value(1) == u"vims") {
        return runVims(arguments.mid(2));
    }
    const auto parsed = parseOptions(arguments);
    if (const auto *words = std::get_if<LastWords>(&parsed)) {
        return sayLastWords(*words);
    }
    return run(std::get<Options>(parsed));
}
