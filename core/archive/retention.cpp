#include "core/archive/retention.h"

#include "core/archive/rollup.h"

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

qint64 usedBytes(ArchiveDatabase &database)
{
    if (!database.isSqlite()) {
        return database
            .single(u"SELECT sum(pg_total_relation_size(oid)) FROM pg_class WHERE relkind = 'r' AND relnamespace = "
                    "current_schema()::regnamespace"_s)
            .toLongLong();
    }
    const qint64 pages = database.single(u"PRAGMA page_count"_s).toLongLong();
    const qint64 unused = database.single(u"PRAGMA freelist_count"_s).toLongLong();
    return (pages - unused) * database.single(u"PRAGMA page_size"_s).toLongLong();
}

Retention::Outcome Retention::sweep(ArchiveStore &store, UtcTime now)
{
    ArchiveDatabase &database = store.database();
    m_hasMore = false;
    if (!database.begin()) {
        return Outcome::Failed;
    }
    if (!sweepAge(database, now) || !sweepSize(database) || !database.commit()) {
        database.rollback();
        return Outcome::Failed;
    }
    if (database.isSqlite()) {
        database.execute(u"PRAGMA incremental_vacuum(%1)"_s.arg(4 * mostRows));
    }
    return m_hasMore ? Outcome::MoreToDo : Outcome::Done;
}

/// \a rows: the statement that selects their ids and names their table first, `chunk WHERE …`.
bool Retention::remove(ArchiveDatabase &database, const QString &rows, const QVariantList &values)
{
    const QString table = rows.section(u' ', 0, 0);
    QSqlQuery *query = database.run(
        u"DELETE FROM %1 WHERE id IN (SELECT id FROM %2 LIMIT %3)"_s.arg(table, rows).arg(mostRows), values);
    m_hasMore = m_hasMore || (query && query->numRowsAffected() == mostRows);
    return query;
}

bool Retention::sweepAge(ArchiveDatabase &database, UtcTime now)
{
    const auto isGood = [&](std::chrono::hours age, const QString &rows, const QVariantList &values) {
        return age.count() == 0 || remove(database, rows, values + QVariantList{storedTime(now - age)});
    };
    bool isAllGood =
        isGood(m_retention.readings, u"chunk WHERE kind = ? AND finish < ?"_s, {static_cast<int>(ChunkKind::FullRate)});
    isAllGood = isAllGood
        && isGood(m_retention.samples, u"chunk WHERE kind = ? AND finish < ?"_s,
                  {static_cast<int>(ChunkKind::Samples)});
    for (const ChunkKind kind : rollupKinds) {
        const QString rows = u"rollup WHERE kind = ? AND start + %1 < ?"_s.arg(stretchOf(kind).count());
        isAllGood = isAllGood && isGood(m_retention.rollups, rows, {static_cast<int>(kind)});
    }
    return isAllGood && isGood(m_retention.events, u"event WHERE time < ?"_s, {})
        && isGood(m_retention.events, u"gap WHERE finish < ?"_s, {});
}

bool Retention::sweepSize(ArchiveDatabase &database)
{
    if (m_retention.mostBytes == 0 || !database.isSqlite() || usedBytes(database) <= m_retention.mostBytes) {
        return true;
    }
    for (const QString &table : {u"chunk"_s, u"event"_s, u"rollup"_s}) {
        if (database.single(u"SELECT id FROM %1 LIMIT 1"_s.arg(table)).isValid()) {
            const bool isGood = remove(database, u"%1 WHERE id > 0 ORDER BY id"_s.arg(table));
            m_hasMore = true;
            return isGood;
        }
    }
    return true;
}

} // namespace gorizont
