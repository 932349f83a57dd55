#include "app/tool/importcommand.h"

#include "app/configfile.h"
#include "app/tool/historyimport.h"
#include "app/tool/output.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

ArchiveConfig archiveOf(const QCommandLineParser &parser, const ServerConfig &config, const QString &configFile)
{
    const QString data = parser.isSet(u"data"_s) ? parser.value(u"data"_s) : QFileInfo(configFile).absolutePath();
    ArchiveConfig archive = archiveConfig(config, data);
    if (parser.isSet(u"archive"_s)) {
        archive.driver = ArchiveDriver::Sqlite;
        archive.file = parser.value(u"archive"_s);
    }
    return archive;
}

void printReport(const ImportReport &report, bool isJson)
{
    if (isJson) {
        print(QJsonObject{
            {u"files"_s, report.files},
            {u"foreign"_s, report.foreign},
            {u"records"_s, report.records},
            {u"damaged"_s, report.damaged},
            {u"added"_s, report.added},
            {u"complaints"_s, QJsonArray::fromStringList(report.complaints)},
            {u"failure"_s, report.failure.isEmpty() ? QJsonValue() : QJsonValue(report.failure)}});
    } else if (report.failure.isEmpty() || report.added > 0) {
        print(Text::tr("%1 files, %2 records, %3 damaged lines; %4 values of sensors were new")
                  .arg(report.files)
                  .arg(report.records)
                  .arg(report.damaged)
                  .arg(report.added));
    }
    for (const QString &complaint : report.complaints) {
        complain(complaint);
    }
    if (!report.failure.isEmpty()) {
        complain(report.failure);
    }
}

} // namespace

void describeImport(QCommandLineParser &parser)
{
    parser.addOption(
        {u"config"_s,
         Text::tr("import-history: the configuration with the sensors of the files; GorizontServer.ini if "
                  "not given."),
         u"FILE"_s, u"GorizontServer.ini"_s});
    parser.addOption(
        {u"data"_s,
         Text::tr("import-history: the folder of the archive's History; the folder of the configuration if not given."),
         u"DIR"_s});
}

ExitCode importHistory(const QCommandLineParser &parser, const QString &folder)
{
    const QString configFile = parser.value(u"config"_s);
    QString why;
    const auto reading = readConfigFile(configFile, &why);
    if (!reading) {
        complain(Text::tr("%1 cannot be read: %2. Name the configuration with --config.")
                     .arg(QDir::toNativeSeparators(configFile), why));
        return ExitUsage;
    }
    HistoryFolder history;
    history.path = folder;
    history.gravity = reading->config.gravity;
    for (const LineConfig &line : reading->config.lines) {
        history.sensors += line.sensors;
    }
    HistoryImport import(history, archiveOf(parser, reading->config, configFile), [](const QString &file, int percent) {
        showProgress(Text::tr("%1: %2 %").arg(file).arg(percent));
    });
    const ImportReport report = import.run(utcNow());
    showProgress({});
    printReport(report, parser.isSet(u"json"_s));
    return report.failure.isEmpty() ? ExitGood : ExitRefused;
}

} // namespace gorizont::tool
