#include "core/config/archivesettingsreader.h"

#include "core/config/sectionreader.h"

#include <QCoreApplication>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int mostDays = 36525;
constexpr int leastSize = 16;

/// A server that is not named cannot be asked.
void settleServer(SectionReader &section, ArchiveSettings &archive)
{
    if (archive.driver == ArchiveDriver::PostgreSql && (archive.host.isEmpty() || archive.database.isEmpty())) {
        section.complain(
            u"Driver"_s, QCoreApplication::translate("ServerConfig", "QPSQL needs Host and Database."),
            QCoreApplication::translate("ServerConfig", "The archive is a file, as with QSQLITE."));
        section.replace(u"Driver"_s);
        archive.driver = ArchiveDriver::Sqlite;
    }
}

/// A server does not give back the room of what is removed: nobody knows there when enough was.
void settleSize(SectionReader &section, ArchiveSettings &archive)
{
    if (archive.mostSize > 0 && archive.driver == ArchiveDriver::PostgreSql) {
        section.complain(
            u"MostSize"_s, QCoreApplication::translate("ServerConfig", "Only an archive of QSQLITE has it."),
            QCoreApplication::translate("ServerConfig", "It is ignored. KeepRaw and KeepSamples bound the archive."));
        section.replace(u"MostSize"_s);
        archive.mostSize = 0;
    } else if (archive.mostSize > 0 && archive.mostSize < leastSize) {
        section.complain(
            u"MostSize"_s,
            QCoreApplication::translate("ServerConfig", "An archive needs at least %1 MB.").arg(leastSize),
            QCoreApplication::translate("ServerConfig", "That size is used."));
        section.replace(u"MostSize"_s);
        archive.mostSize = leastSize;
    }
}

/// Rollups are what is left of readings that were removed.
void settleRollups(SectionReader &section, ArchiveSettings &archive)
{
    const bool isForEver = archive.keepRaw == 0 && archive.keepRollups > 0;
    if (isForEver || (archive.keepRollups > 0 && archive.keepRollups < archive.keepRaw)) {
        section.complain(
            u"KeepRollups"_s,
            QCoreApplication::translate("ServerConfig", "Rollups cannot be removed before the readings of KeepRaw."),
            QCoreApplication::translate("ServerConfig", "They are kept as long as those."));
        section.replace(u"KeepRollups"_s);
        archive.keepRollups = archive.keepRaw;
    }
}

} // namespace

ArchiveSettings readArchiveSettings(const IniFile &file, Findings &findings)
{
    SectionReader section(file, u"Archive"_s, findings);
    ArchiveSettings archive;
    section.take(u"On"_s, archive.isOn);
    section.take<ArchiveDriver>(
        u"Driver"_s, archive.driver, {{u"QSQLITE"_s, ArchiveDriver::Sqlite}, {u"QPSQL"_s, ArchiveDriver::PostgreSql}});
    section.take(u"File"_s, archive.file);
    section.take(u"Host"_s, archive.host);
    section.take(u"Port"_s, archive.port, {1, 65535});
    section.take(u"Database"_s, archive.database);
    section.take(u"User"_s, archive.user);
    section.take(u"PasswordFile"_s, archive.passwordFile);
    section.take(u"Site"_s, archive.site);
    section.take(u"KeepRaw"_s, archive.keepRaw, {0, mostDays});
    section.take(u"KeepSamples"_s, archive.keepSamples, {0, mostDays});
    section.take(u"KeepRollups"_s, archive.keepRollups, {0, mostDays});
    section.take(u"KeepEvents"_s, archive.keepEvents, {0, mostDays});
    section.take(u"MostSize"_s, archive.mostSize, {0});
    settleServer(section, archive);
    settleSize(section, archive);
    settleRollups(section, archive);
    return archive;
}

} // namespace gorizont
