#include "core/archive/archiveschema.h"

namespace gorizont {

namespace {

using Qt::Literals::StringLiterals::operator""_s;

QList<QStringList> migrations(const QString &serial, const QString &blob)
{
    const QStringList first{
        u"CREATE TABLE meta (name VARCHAR(16) PRIMARY KEY, value BIGINT NOT NULL)"_s,
        u"CREATE TABLE sensor (number INTEGER PRIMARY KEY, known_from BIGINT NOT NULL, known_until BIGINT NOT NULL, "
        "readings_done BIGINT NOT NULL, samples_done BIGINT NOT NULL)"_s,
        u"CREATE TABLE chunk (id %1, kind SMALLINT NOT NULL, number INTEGER NOT NULL, start BIGINT NOT NULL, "
        "finish BIGINT NOT NULL, data %2 NOT NULL)"_s.arg(serial, blob),
        u"CREATE INDEX chunk_by_time ON chunk (kind, number, start)"_s,
        u"CREATE TABLE rollup (id %1, kind SMALLINT NOT NULL, number INTEGER NOT NULL, quantity SMALLINT NOT NULL, "
        "start BIGINT NOT NULL, data %2 NOT NULL)"_s.arg(serial, blob),
        u"CREATE UNIQUE INDEX rollup_by_time ON rollup (kind, number, quantity, start)"_s,
        u"CREATE TABLE tail (id %1, data %2 NOT NULL)"_s.arg(serial, blob),
        u"CREATE TABLE gap (id %1, number INTEGER NOT NULL, start BIGINT NOT NULL, finish BIGINT, "
        "reason SMALLINT NOT NULL, source VARCHAR(64) NOT NULL)"_s.arg(serial),
        u"CREATE UNIQUE INDEX gap_by_time ON gap (number, start)"_s,
        u"CREATE TABLE event (id %1, time BIGINT NOT NULL, kind SMALLINT NOT NULL, port INTEGER NOT NULL, "
        "number INTEGER NOT NULL, text TEXT NOT NULL)"_s.arg(serial),
        u"CREATE INDEX event_by_time ON event (time)"_s,
        u"CREATE TABLE record (id %1, number INTEGER NOT NULL, start BIGINT NOT NULL, name VARCHAR(64) NOT NULL, "
        "data %2 NOT NULL)"_s.arg(serial, blob),
        u"CREATE UNIQUE INDEX record_by_time ON record (number, start, name)"_s,
    };
    return {first};
}

} // namespace

const QList<QStringList> &archiveMigrations(ArchiveDriver driver)
{
    static const auto sqlite = migrations(u"INTEGER PRIMARY KEY AUTOINCREMENT"_s, u"BLOB"_s);
    static const auto postgreSql = migrations(u"BIGSERIAL PRIMARY KEY"_s, u"BYTEA"_s);
    return driver == ArchiveDriver::Sqlite ? sqlite : postgreSql;
}

} // namespace gorizont
