#include "app/tool/exportprogram.h"

#include "app/archivesource.h"
#include "app/configfile.h"
#include "app/tool/exportcommand.h"
#include "app/tool/exportoptions.h"
#include "app/tool/output.h"
#include "app/tool/subprogram.h"
#include "app/tool/text.h"
#include "core/archive/archivereader.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

ExportSite siteOf(const ServerConfig &config)
{
    ExportSite site;
    site.name = config.name;
    for (const LineConfig &line : config.lines) {
        site.sensors += line.sensors;
    }
    return site;
}

void describe(QCommandLineParser &parser)
{
    describeExport(parser);
    parser.addOption(
        {u"data"_s, Text::tr("The folder with History; the folder of the configuration if not given."), u"DIR"_s});
}

QString dataFolder(const QCommandLineParser &parser, const QString &configFile)
{
    const QString given = parser.value(u"data"_s);
    return given.isEmpty() ? QFileInfo(configFile).absolutePath() : given;
}

ExitCode usageError(const QString &problem)
{
    complain(problem);
    return ExitUsage;
}

} // namespace

ExitCode runExportProgram(const QStringList &arguments)
{
    QCommandLineParser parser;
    describe(parser);
    if (const auto ended = parseSubprogram(parser, u"export"_s, arguments)) {
        return *ended;
    }
    const QString configFile = parser.isSet(u"config"_s) ? parser.value(u"config"_s) : u"GorizontServer.ini"_s;
    QString why;
    const auto reading = readConfigFile(configFile, &why);
    if (!reading) {
        return usageError(Text::tr("%1 cannot be read: %2. Name the configuration with --config.")
                              .arg(QDir::toNativeSeparators(configFile), why));
    }
    const auto request = exportRequest(parser, siteOf(reading->config));
    if (const auto *problem = std::get_if<QString>(&request)) {
        return usageError(*problem);
    }
    ArchiveReader archive(archiveConfig(reading->config, dataFolder(parser, configFile)));
    return exportHistory(std::get<ExportRequest>(request), archiveSource(archive), parser.isSet(u"json"_s));
}

} // namespace gorizont::tool
