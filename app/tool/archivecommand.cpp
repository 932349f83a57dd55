#include "app/tool/archivecommand.h"

#include "app/tool/importcommand.h"
#include "app/tool/output.h"
#include "app/tool/subprogram.h"
#include "app/tool/text.h"
#include "core/archive/inspection.h"

#include <QCommandLineParser>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

void describe(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        Text::tr(
            "Looks after the archive of Gorizont Server; the server may run meanwhile, only not for import-history.")
        + u"\n\n"_s
        + Text::tr("check               reads all of it and compares every check sum\n"
                   "stat                prints what is in it\n"
                   "backup TARGET       copies it as it is at this moment to a file that does not exist yet\n"
                   "import-history DIR  takes over the text and binary files of the folder History where the archive "
                   "knows nothing")
        + u"\n\n"_s
        + Text::tr("Exit codes: 0 done; 1 it is damaged, or cannot be read, copied or written; 2 the command line is "
                   "wrong."));
    parser.addPositionalArgument(
        u"command"_s, Text::tr("One of the commands above."), u"check|stat|backup TARGET|import-history DIR"_s);
    parser.addOption(
        {u"archive"_s,
         Text::tr("The file; if not given, History/archive.sqlite, and for import-history the archive "
                  "of the configuration."),
         u"FILE"_s, u"History/archive.sqlite"_s});
    describeImport(parser);
    parser.addOption({u"json"_s, Text::tr("Prints JSON.")});
    parser.addOption({u"lang"_s, Text::tr("Language of the program."), u"ru|en"_s});
    parser.addOption({u"help"_s, Text::tr("Prints this.")});
}

QList<std::pair<QString, qint64>> numbersOf(const ArchiveReport &report, bool isChecked)
{
    QList<std::pair<QString, qint64>> numbers{{u"bytes"_s, report.bytes},     {u"chunks"_s, report.chunks},
                                              {u"rollups"_s, report.rollups}, {u"tail"_s, report.commits},
                                              {u"events"_s, report.events},   {u"gaps"_s, report.gaps},
                                              {u"records"_s, report.records}};
    if (isChecked) {
        numbers << std::pair(u"readings"_s, report.readings) << std::pair(u"samples"_s, report.samples)
                << std::pair(u"damaged"_s, report.damaged);
    }
    return numbers;
}

void printReport(const ArchiveReport &report, bool isChecked, bool isJson)
{
    QJsonObject object;
    for (const auto &[name, number] : numbersOf(report, isChecked)) {
        object.insert(name, number);
        if (!isJson) {
            print(u"%1 %2"_s.arg(name, -10).arg(number));
        }
    }
    if (isJson) {
        print(object);
    }
    for (const QString &problem : report.problems) {
        complain(problem);
    }
}

ExitCode report(const ArchiveConfig &config, bool isChecked, bool isJson)
{
    QString error;
    const auto found = isChecked ? inspectArchive(config, &error) : countArchive(config, &error);
    if (!found) {
        complain(error);
        return ExitRefused;
    }
    printReport(*found, isChecked, isJson);
    return found->isGood() ? ExitGood : ExitRefused;
}

ExitCode backUp(const ArchiveConfig &config, const QString &target)
{
    QString error;
    if (!backUpArchive(config, target, &error)) {
        complain(error);
        return ExitRefused;
    }
    print(target);
    return ExitGood;
}

} // namespace

ExitCode runArchive(const QStringList &arguments)
{
    QCommandLineParser parser;
    describe(parser);
    if (const auto ended = parseSubprogram(parser, u"archive"_s, arguments)) {
        return *ended;
    }
    const QStringList words = parser.positionalArguments();
    const QString command = words.value(0);
    const bool isBackup = command == u"backup" && words.size() == 2;
    const bool isImport = command == u"import-history" && words.size() == 2;
    const bool isReport = (command == u"check" || command == u"stat") && words.size() == 1;
    if (!isBackup && !isReport && !isImport) {
        complain(Text::tr(
            "archive takes check, stat, backup TARGET or import-history DIR; see gorizont-tool archive --help"));
        return ExitUsage;
    }
    if (isImport) {
        return importHistory(parser, words.at(1));
    }
    ArchiveConfig config;
    config.file = parser.value(u"archive"_s);
    return isBackup ? backUp(config, words.at(1)) : report(config, command == u"check", parser.isSet(u"json"_s));
}

} // namespace gorizont::tool
