#include "core/archive/archivestore.h"

#include "core/archive/openchunks.h"
#include "core/archive/rollup.h"

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

qint64 storedTime(UtcTime time)
{
    return time.time_since_epoch().count();
}

UtcTime readTime(const QVariant &value)
{
    return UtcTime(std::chrono::microseconds(value.toLongLong()));
}

std::optional<UtcTime> ArchiveStore::aliveAt()
{
    const QVariant value = m_database.single(u"SELECT value FROM meta WHERE name = 'alive'"_s);
    return value.isValid() ? std::optional(readTime(value)) : std::nullopt;
}

bool ArchiveStore::setAlive(UtcTime now)
{
    return m_database.run(
        u"INSERT INTO meta (name, value) VALUES ('alive', ?) ON CONFLICT (name) DO UPDATE SET value = excluded.value"_s,
        {storedTime(now)});
}

std::optional<SpoolMark> ArchiveStore::applied()
{
    QSqlQuery *query = m_database.run(u"SELECT name, value FROM meta WHERE name IN ('spool', 'spooled')"_s);
    if (!query) {
        return {};
    }
    SpoolMark mark;
    while (query->next()) {
        (query->value(0).toString() == u"spool" ? mark.spool : mark.sequence) = query->value(1).toLongLong();
    }
    return m_database.isWhole(query) ? std::optional(mark) : std::nullopt;
}

bool ArchiveStore::setApplied(const SpoolMark &mark)
{
    return m_database.run(
        u"INSERT INTO meta (name, value) VALUES ('spool', ?), ('spooled', ?) ON CONFLICT (name) DO UPDATE SET value = "
        "excluded.value"_s,
        {mark.spool, mark.sequence});
}

std::optional<SalvageMark> ArchiveStore::salvageMark()
{
    QSqlQuery *query = m_database.run(u"SELECT name, value FROM meta WHERE name LIKE 'salvage%'"_s);
    QHash<QString, qint64> values;
    while (query && query->next()) {
        values.insert(query->value(0).toString(), query->value(1).toLongLong());
    }
    if (!m_database.isWhole(query)) {
        return {};
    }
    return SalvageMark{
        values.value(u"salvage"_s), static_cast<int>(values.value(u"salvage_table"_s)), values.value(u"salvage_last"_s),
        values.value(u"salvage_rows"_s), values.value(u"salvage_tail"_s) != 0};
}

bool ArchiveStore::setSalvageMark(const SalvageMark &mark)
{
    if (mark.copy == 0) {
        return m_database.run(u"DELETE FROM meta WHERE name LIKE 'salvage%'"_s);
    }
    return m_database.run(
        u"INSERT INTO meta (name, value) VALUES ('salvage', ?), ('salvage_table', ?), ('salvage_last', ?), "
        "('salvage_rows', ?), ('salvage_tail', ?) ON CONFLICT (name) DO UPDATE SET value = excluded.value"_s,
        {mark.copy, mark.table, mark.last, mark.rescued, mark.takesTail ? 1 : 0});
}

std::optional<QList<ArchiveStore::TailRow>> ArchiveStore::tail()
{
    QSqlQuery *query = m_database.run(u"SELECT id, data FROM tail ORDER BY id"_s);
    if (!query) {
        return {};
    }
    QList<TailRow> rows;
    while (query->next()) {
        rows.append({query->value(0).toLongLong(), query->value(1).toByteArray()});
    }
    return m_database.isWhole(query) ? std::optional(rows) : std::nullopt;
}

std::optional<qint64> ArchiveStore::appendTail(const QByteArray &data)
{
    QSqlQuery *query = m_database.run(u"INSERT INTO tail (data) VALUES (?) RETURNING id"_s, {data});
    if (!query || !query->next()) {
        m_database.isWhole(query);
        return {};
    }
    const qint64 id = query->value(0).toLongLong();
    query->finish();
    return id;
}

bool ArchiveStore::removeTailBelow(qint64 id)
{
    return m_database.run(u"DELETE FROM tail WHERE id < ?"_s, {id});
}

std::optional<QHash<int, KnownSensor>> ArchiveStore::sensors()
{
    QSqlQuery *query =
        m_database.run(u"SELECT number, known_from, known_until, readings_done, samples_done FROM sensor"_s);
    if (!query) {
        return {};
    }
    QHash<int, KnownSensor> sensors;
    while (query->next()) {
        sensors.insert(
            query->value(0).toInt(),
            {readTime(query->value(1)), readTime(query->value(2)), query->value(3).toLongLong(),
             query->value(4).toLongLong()});
    }
    return m_database.isWhole(query) ? std::optional(sensors) : std::nullopt;
}

bool ArchiveStore::putSensor(int number, const KnownSensor &sensor)
{
    return m_database.run(
        u"INSERT INTO sensor (number, known_from, known_until, readings_done, samples_done) VALUES (?, ?, ?, ?, ?) "
        "ON CONFLICT (number) DO UPDATE SET known_from = excluded.known_from, known_until = excluded.known_until, "
        "readings_done = excluded.readings_done, samples_done = excluded.samples_done"_s,
        {number, storedTime(sensor.from), storedTime(sensor.until), sensor.readingsDone, sensor.samplesDone});
}

bool ArchiveStore::appendChunk(ChunkKind kind, int number, const TimeSpan &span, const QByteArray &data)
{
    return m_database.run(
        u"INSERT INTO chunk (kind, number, start, finish, data) VALUES (?, ?, ?, ?, ?)"_s,
        {static_cast<int>(kind), number, storedTime(span.from), storedTime(span.to), data});
}

std::optional<QByteArray> ArchiveStore::rollup(ChunkKind kind, const SeriesKey &key, UtcTime stretch)
{
    const QVariant data = m_database.single(
        u"SELECT data FROM rollup WHERE kind = ? AND number = ? AND quantity = ? AND start = ?"_s,
        {static_cast<int>(kind), key.number, static_cast<int>(key.quantity), storedTime(stretch)});
    return data.isValid() ? std::optional(data.toByteArray()) : std::nullopt;
}

bool ArchiveStore::putRollup(ChunkKind kind, const SeriesKey &key, UtcTime stretch, const QByteArray &data)
{
    return m_database.run(
        u"INSERT INTO rollup (kind, number, quantity, start, data) VALUES (?, ?, ?, ?, ?) "
        "ON CONFLICT (kind, number, quantity, start) DO UPDATE SET data = excluded.data"_s,
        {static_cast<int>(kind), key.number, static_cast<int>(key.quantity), storedTime(stretch), data});
}

std::optional<QList<QByteArray>> ArchiveStore::dataOf(const QString &rows, const QVariantList &values)
{
    QSqlQuery *query = m_database.run(u"SELECT data FROM %1 ORDER BY start"_s.arg(rows), values);
    QList<QByteArray> data;
    while (query && query->next()) {
        data.append(query->value(0).toByteArray());
    }
    return m_database.isWhole(query) ? std::optional(data) : std::nullopt;
}

std::optional<QList<QByteArray>> ArchiveStore::rollups(ChunkKind kind, const SeriesKey &key, const TimeSpan &span)
{
    return dataOf(
        u"rollup WHERE kind = ? AND number = ? AND quantity = ? AND start > ? AND start < ?"_s,
        {static_cast<int>(kind), key.number, static_cast<int>(key.quantity), storedTime(span.from - stretchOf(kind)),
         storedTime(span.to)});
}

std::optional<QList<QByteArray>> ArchiveStore::chunks(ChunkKind kind, int number, const TimeSpan &span)
{
    return dataOf(
        u"chunk WHERE kind = ? AND number = ? AND start >= ? AND start < ? AND finish > ?"_s,
        {static_cast<int>(kind), number, storedTime(span.from - 2 * OpenChunks::longest), storedTime(span.to),
         storedTime(span.from)});
}

bool ArchiveStore::putGap(const Gap &gap)
{
    return m_database.run(
        u"INSERT INTO gap (number, start, finish, reason, source) VALUES (?, ?, ?, ?, ?) "
        "ON CONFLICT (number, start) DO UPDATE SET finish = excluded.finish, reason = excluded.reason, "
        "source = excluded.source"_s,
        {gap.number, storedTime(gap.from),
         gap.to ? QVariant(storedTime(*gap.to)) : QVariant(QMetaType(QMetaType::LongLong)),
         static_cast<int>(gap.reason), gap.filledFrom.isNull() ? u""_s : gap.filledFrom});
}

bool ArchiveStore::removeGap(int number, UtcTime start)
{
    return m_database.run(u"DELETE FROM gap WHERE number = ? AND start = ?"_s, {number, storedTime(start)});
}

std::optional<QList<Gap>> ArchiveStore::gapsWhere(int number, const QString &condition, const QVariantList &values)
{
    QSqlQuery *query = m_database.run(
        u"SELECT start, finish, reason, source FROM gap WHERE number = ? AND %1 ORDER BY start"_s.arg(condition),
        QVariantList{number} + values);
    if (!query) {
        return {};
    }
    QList<Gap> gaps;
    while (query->next()) {
        Gap gap{number, readTime(query->value(0)), {}, static_cast<GapReason>(query->value(2).toInt()), {}};
        gap.to = query->isNull(1) ? std::nullopt : std::optional(readTime(query->value(1)));
        gap.filledFrom = query->value(3).toString();
        gaps.append(gap);
    }
    return m_database.isWhole(query) ? std::optional(gaps) : std::nullopt;
}

std::optional<QList<Gap>> ArchiveStore::gaps(int number, const TimeSpan &span)
{
    return gapsWhere(
        number, u"start <= ? AND (finish IS NULL OR finish >= ?)"_s, {storedTime(span.to), storedTime(span.from)});
}

std::optional<QList<Gap>> ArchiveStore::gapsBeginning(int number, const TimeSpan &span)
{
    return gapsWhere(number, u"start >= ? AND start < ?"_s, {storedTime(span.from), storedTime(span.to)});
}

std::optional<UtcTime> ArchiveStore::firstGap(int number)
{
    const QVariant first =
        m_database.single(u"SELECT start FROM gap WHERE number = ? ORDER BY start LIMIT 1"_s, {number});
    return first.isValid() ? std::optional(readTime(first)) : std::nullopt;
}

std::optional<QHash<int, UtcTime>> ArchiveStore::endOpenGaps(UtcTime at)
{
    if (!m_database.run(
            u"UPDATE gap SET finish = CASE WHEN start > ? THEN start ELSE ? END WHERE finish IS NULL"_s,
            {storedTime(at), storedTime(at)})) {
        return {};
    }
    QSqlQuery *query = m_database.run(u"SELECT number, max(finish) FROM gap GROUP BY number"_s);
    if (!query) {
        return {};
    }
    QHash<int, UtcTime> ends;
    while (query->next()) {
        ends.insert(query->value(0).toInt(), readTime(query->value(1)));
    }
    return m_database.isWhole(query) ? std::optional(ends) : std::nullopt;
}

bool ArchiveStore::appendEvent(const JournalEntry &entry)
{
    return m_database.run(
        u"INSERT INTO event (time, kind, port, number, text) VALUES (?, ?, ?, ?, ?)"_s,
        {storedTime(entry.time), static_cast<int>(entry.kind), entry.port, entry.number,
         entry.text.isNull() ? u""_s : entry.text});
}

bool ArchiveStore::putRecord(const DeviceRecord &record, bool *isNew)
{
    QSqlQuery *query = m_database.run(
        u"INSERT INTO record (number, start, name, data) VALUES (?, ?, ?, ?) ON CONFLICT (number, start, name) "
        "DO NOTHING"_s,
        {record.number, storedTime(record.start), record.name, record.data});
    *isNew = query && query->numRowsAffected() > 0;
    return query;
}

std::optional<std::vector<UtcTime>> ArchiveStore::recordTimes(int number, const TimeSpan &span)
{
    QSqlQuery *query = m_database.run(
        u"SELECT DISTINCT start FROM record WHERE number = ? AND start >= ? AND start < ? ORDER BY start"_s,
        {number, storedTime(span.from), storedTime(span.to)});
    if (!query) {
        return {};
    }
    std::vector<UtcTime> times;
    while (query->next()) {
        times.push_back(readTime(query->value(0)));
    }
    return m_database.isWhole(query) ? std::optional(times) : std::nullopt;
}

std::optional<QList<TimeSpan>> ArchiveStore::chunkSpans(ChunkKind kind, int number, const TimeSpan &span)
{
    QSqlQuery *query = m_database.run(
        u"SELECT start, finish FROM chunk WHERE kind = ? AND number = ? AND start >= ? AND start < ? ORDER BY start"_s,
        {static_cast<int>(kind), number, storedTime(span.from), storedTime(span.to)});
    if (!query) {
        return {};
    }
    QList<TimeSpan> spans;
    while (query->next()) {
        spans.append({readTime(query->value(0)), readTime(query->value(1))});
    }
    return m_database.isWhole(query) ? std::optional(spans) : std::nullopt;
}

} // namespace gorizont
