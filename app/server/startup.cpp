#include "app/server/startup.h"

#include "app/configfile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace gorizont {

namespace {

const QString fileName = QStringLiteral("GorizontServer.ini");
const QString demoFile = QStringLiteral(":/demo.ini");

class Startup
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Startup)
};

/// --data, else the folder of the ini; the demonstration has one of its own.
QString dataFolder(const Options &options, const QString &configFile)
{
    if (!options.dataFolder.isEmpty()) {
        return options.dataFolder;
    }
    if (options.isDemo) {
        return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/demo");
    }
    return QFileInfo(configFile).absolutePath();
}

/// Files that the ini names lie beside it unless it says otherwise.
void resolveFiles(MqttSettings &mqtt, const QString &folder)
{
    for (QString *path : {&mqtt.caFile, &mqtt.certFile, &mqtt.keyFile, &mqtt.passwordFile}) {
        if (!path->isEmpty()) {
            *path = QDir(folder).absoluteFilePath(*path);
        }
    }
}

/// So do the folders of stations that run in this program.
void resolveStations(QList<LineConfig> &lines, const QString &folder)
{
    const QString scheme = QStringLiteral("station:");
    for (LineConfig &line : lines) {
        if (line.device.startsWith(scheme, Qt::CaseInsensitive)) {
            line.device = scheme + QDir(folder).absoluteFilePath(line.device.sliced(scheme.size()));
        }
    }
}

} // namespace

QString findConfigFile(const Options &options)
{
    if (options.isDemo) {
        return demoFile;
    }
    if (!options.configFile.isEmpty()) {
        return options.configFile;
    }
    const QStringList places{
        QCoreApplication::applicationDirPath(), QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)};
    for (const QString &place : places) {
        const QString path = QDir(place).filePath(fileName);
        if (QFileInfo::exists(path)) {
            return path;
        }
    }
    return {};
}

std::optional<ConfigReading> loadConfig(const QString &configFile, QString *problem)
{
    QString why;
    auto reading = readConfigFile(configFile, &why);
    if (!reading) {
        *problem = Startup::tr("%1 cannot be read (%2). Check the name and the rights of the file.")
                       .arg(QDir::toNativeSeparators(configFile), why);
    }
    return reading;
}

std::optional<Site> loadSite(const Options &options, const QString &configFile, QString *problem)
{
    Site site;
    auto reading = loadConfig(configFile, problem);
    if (!reading) {
        return std::nullopt;
    }
    site.reading = *std::move(reading);
    resolveFiles(site.reading.config.mqtt, QFileInfo(configFile).absolutePath());
    resolveStations(site.reading.config.lines, QFileInfo(configFile).absolutePath());
    site.configFile = options.isDemo ? configFile : QFileInfo(configFile).absoluteFilePath();
    const QString folder = dataFolder(options, configFile);
    if (!QDir().mkpath(folder)) {
        *problem = Startup::tr("The folder %1 for the data cannot be made. Choose another one with --data.")
                       .arg(QDir::toNativeSeparators(folder));
        return std::nullopt;
    }
    site.dataFolder = QFileInfo(folder).absoluteFilePath();
    return site;
}

} // namespace gorizont
