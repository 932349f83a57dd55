#include "core/archive/retention.h"

#include "core/archive/rollup.h"
#include "core/values/quantity.h"

#include <algorithm>

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

QString expiredRows(ChunkKind kind)
{
    if (kind == ChunkKind::FullRate || kind == ChunkKind::Samples) {
        return u"chunk WHERE kind = %1 AND number IN (SELECT number FROM sensor) AND start < ? AND finish < ?"_s.arg(
            static_cast<int>(kind));
    }
    QStringList quantities;
    for (const Quantity quantity : readingQuantities() + QList{Quantity::SampleX, Quantity::SampleY}) {
        quantities.append(QString::number(static_cast<int>(quantity)));
    }
    return u"rollup WHERE kind = %1 AND number IN (SELECT number FROM sensor) AND quantity IN (%2) AND start < ?"_s
        .arg(static_cast<int>(kind))
        .arg(quantities.join(u", "_s));
}

Retention::Outcome Retention::sweep(ArchiveStore &store, UtcTime now, Room room)
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
    if (database.isSqlite() && room == Room::GivenBack && !shrink(database)) {
        return Outcome::Failed;
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

/// The pragma makes a row of every page that it gives back, and one execution goes no further than to the first.
bool Retention::shrink(ArchiveDatabase &database)
{
    const auto pages = [&database] { return database.single(u"PRAGMA page_count"_s).toLongLong(); };
    const qint64 unused = database.single(u"PRAGMA freelist_count"_s).toLongLong();
    const qint64 before = pages();
    if (unused == 0) {
        return true;
    }
    bool isGood = database.begin();
    for (qint64 page = 0; isGood && page < std::min(unused, mostPages); ++page) {
        QSqlQuery *step = database.run(u"PRAGMA incremental_vacuum(1)"_s);
        isGood = step != nullptr;
        if (step) {
            step->finish();
        }
    }
    if (!isGood || !database.commit()) {
        database.rollback();
        return false;
    }
    m_hasMore = m_hasMore || (unused > mostPages && pages() < before);
    return true;
}

bool Retention::sweepAge(ArchiveDatabase &database, UtcTime now)
{
    const auto isGood = [&](std::chrono::hours age, const QString &rows, const QVariantList &values) {
        return age.count() == 0 || remove(database, rows, values);
    };
    const qint64 readings = storedTime(now - m_retention.readings);
    const qint64 samples = storedTime(now - m_retention.samples);
    const qint64 events = storedTime(now - m_retention.events);
    bool isAllGood = isGood(m_retention.readings, expiredRows(ChunkKind::FullRate), {readings, readings})
        && isGood(m_retention.samples, expiredRows(ChunkKind::Samples), {samples, samples});
    for (const ChunkKind kind : rollupKinds) {
        const qint64 before = storedTime(now - m_retention.rollups - stretchOf(kind));
        isAllGood = isAllGood && isGood(m_retention.rollups, expiredRows(kind), {before});
    }
    return isAllGood && isGood(m_retention.events, u"event WHERE time < ?"_s, {events})
        && isGood(m_retention.events, u"gap WHERE finish < ?"_s, {events});
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
