#include "ui/models/storagesettings.h"

#include "ui/models/settingssection.h"
#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

namespace gorizont {

namespace {

QString days(int count)
{
    return count > 0 ? Settings::tr("%1 d").arg(count) : Settings::tr("for ever");
}

void addPlace(const ArchiveSettings &archive, SettingsSection &section)
{
    if (archive.driver == ArchiveDriver::Sqlite) {
        section.add(
            "File", Settings::tr("File"),
            archive.file.isEmpty() ? QStringLiteral("History/archive.sqlite") : archive.file,
            Settings::tr("counted from the folder of the data"));
        return;
    }
    section.add("Host", Settings::tr("Server"), archive.host, Settings::tr("name or address of the PostgreSQL server"));
    section.add(
        "Port", Settings::tr("Port of the server"), QString::number(archive.port), Settings::tr("usually 5432"));
    section.add("Database", Settings::tr("Database"), archive.database, Settings::tr("name of the database there"));
    section.add(
        "User", Settings::tr("User"), valuetext::orAbsent(archive.user), Settings::tr("who writes into the database"));
    section.add(
        "PasswordFile", Settings::tr("File with the password"), valuetext::orAbsent(archive.passwordFile),
        Settings::tr("its first line is the password"));
    section.add(
        "Site", Settings::tr("Site"), archive.site, Settings::tr("schema of this site, so that many share a database"));
}

void addArchive(const ServerConfig &config, Properties &list)
{
    const ArchiveSettings &archive = config.archive;
    SettingsSection section(config, list, QStringLiteral("[Archive]"), QStringLiteral("Archive"));
    section.add(
        "On", Settings::tr("Keep an archive"), statetext::yesNo(archive.isOn),
        Settings::tr("keep every reading, for trends and history?"));
    if (!archive.isOn) {
        return;
    }
    section.add(
        "Driver", Settings::tr("Kept in"),
        archive.driver == ArchiveDriver::Sqlite ? Settings::tr("a file") : Settings::tr("PostgreSQL"),
        Settings::tr("QSQLITE: a file of its own; QPSQL: a PostgreSQL server"));
    addPlace(archive, section);
    section.add("KeepRaw", Settings::tr("Readings kept"), days(archive.keepRaw), Settings::tr("how long at full rate"));
    section.add(
        "KeepSamples", Settings::tr("Samples kept"), days(archive.keepSamples),
        Settings::tr("how long the samples of accelerometers"));
    section.add(
        "KeepRollups", Settings::tr("Sums kept"), days(archive.keepRollups),
        Settings::tr("how long the sums of minutes, hours and days"));
    section.add(
        "KeepEvents", Settings::tr("Events kept"), days(archive.keepEvents),
        Settings::tr("how long events of the journal and gaps"));
    section.add(
        "MostSize", Settings::tr("Size at most"),
        archive.mostSize > 0 ? Settings::tr("%1 MB").arg(archive.mostSize) : Settings::tr("any"),
        Settings::tr("the oldest goes first"));
}

void addChain(const ServerConfig &config, const ChainConfig &chain, Properties &list)
{
    const QString name = QStringLiteral("Chain%1").arg(chain.index);
    SettingsSection section(config, list, u'[' + name + u']', name);
    section.add(
        "Name", Settings::tr("Comment"), valuetext::orAbsent(chain.name), Settings::tr("what the sensors stand on"));
    for (qsizetype i = 0; i < chain.links.size(); ++i) {
        const ChainLink &link = chain.links.at(i);
        section.add(
            QStringLiteral("N%1|L%1").arg(i + 1), Settings::tr("Link %1").arg(i + 1),
            Settings::tr("sensor %1, %2 m").arg(link.number).arg(link.length),
            Settings::tr("number of the sensor and length of its link, from the bottom"));
    }
}

} // namespace

Properties storageSettings(const ServerConfig &config)
{
    Properties list;
    addArchive(config, list);
    for (const ChainConfig &chain : config.chains) {
        addChain(config, chain, list);
    }
    return list;
}

} // namespace gorizont
