#include "core/archive/salvage.h"

#include "core/archive/openchunks.h"
#include "core/archive/rollupchunk.h"

#include <QSqlError>

#include <array>

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

constexpr int rowsAtATime = 100;
constexpr qint64 longestStride = 1024;

enum Table : int { ChunkTable, RollupTable, EventTable, GapTable, RecordTable, TailTable, TableCount };

struct Source
{
    QString name;
    QString columns;
};

const Source &sourceOf(int table)
{
    static const std::array<Source, TableCount> sources{{
        {u"chunk"_s, u"id, kind, number, start, finish, data"_s},
        {u"rollup"_s, u"id, kind, number, quantity, start, data"_s},
        {u"event"_s, u"id, time, kind, port, number, text"_s},
        {u"gap"_s, u"id, number, start, finish, reason, source"_s},
        {u"record"_s, u"id, number, start, name, data"_s},
        {u"tail"_s, u"id, data"_s},
    }};
    return sources[static_cast<std::size_t>(table)];
}

} // namespace

Salvage::Salvage(const QString &file, const ArchiveConfig &config, const SalvageMark &from)
    : m_database(
        [&] {
            ArchiveConfig damaged = config;
            damaged.file = file;
            return damaged;
        }(),
        ArchiveDatabase::Access::Salvage)
    , m_from(from)
    , m_position{from.table, from.last, 1, rowsAtATime}
    , m_rescued(from.rescued)
{
    for (const LineConfig &line : config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            m_offsets.insert(sensor.number, {sensor.offsetX, sensor.offsetY, sensor.offsetT});
        }
    }
}

Salvage::Outcome Salvage::step(ArchiveStore &store, RollupBook &rollups)
{
    m_before = m_position;
    m_rescuedBefore = m_rescued;
    if (!m_database.isOpen() && (!m_database.open() || !takeKnown())) {
        return Outcome::Done;
    }
    if (m_position.table == TableCount || (m_position.table == TailTable && !m_from.takesTail)) {
        return Outcome::Done;
    }
    const Source &source = sourceOf(m_position.table);
    QSqlQuery *rows = m_database.run(
        u"SELECT %1 FROM %2 WHERE id > ? ORDER BY id LIMIT ?"_s.arg(source.columns, source.name),
        {m_position.last, m_position.rows});
    int count = 0;
    while (rows && rows->next()) {
        if (!takeRow(*rows, store, rollups)) {
            return Outcome::Failed;
        }
        m_position.last = rows->value(0).toLongLong();
        ++count;
    }
    const bool wasWhole = rows && !rows->lastError().isValid();
    if (!wasWhole) {
        stepOver();
    } else if (count == 0) {
        m_position = {m_position.table + 1, 0, 1, rowsAtATime};
    } else {
        m_position.stride = 1;
        m_position.rows = rowsAtATime;
    }
    return Outcome::MoreToDo;
}

void Salvage::undo()
{
    m_position = m_before;
    m_rescued = m_rescuedBefore;
}

SalvageMark Salvage::mark() const
{
    return {m_from.copy, m_position.table, m_position.last, m_rescued, m_from.takesTail};
}

/// First row by row up to what cannot be read, then over it.
void Salvage::stepOver()
{
    if (m_position.rows > 1) {
        m_position.rows = 1;
        return;
    }
    m_position.last += m_position.stride;
    m_position.stride = std::min(2 * m_position.stride, longestStride);
    if (m_position.last > lastId()) {
        m_position = {m_position.table + 1, 0, 1, rowsAtATime};
    }
}

qint64 Salvage::lastId()
{
    return m_database.single(u"SELECT seq FROM sqlite_sequence WHERE name = ?"_s, {sourceOf(m_position.table).name})
        .toLongLong();
}

bool Salvage::takeKnown()
{
    QSqlQuery *rows =
        m_database.run(u"SELECT number, known_from, known_until, readings_done, samples_done FROM sensor"_s);
    while (rows && rows->next()) {
        const KnownSensor known{
            readTime(rows->value(1)), readTime(rows->value(2)), rows->value(3).toLongLong(),
            rows->value(4).toLongLong()};
        m_known.insert(rows->value(0).toInt(), known);
        m_knownFrom.insert(rows->value(0).toInt(), known.from);
    }
    return true;
}

bool Salvage::takeRow(const QSqlQuery &row, ArchiveStore &store, RollupBook &rollups)
{
    ++m_rescued;
    bool isNew = false;
    switch (m_position.table) {
    case ChunkTable: return takeChunk(row, store);
    case RollupTable: return takeRollup(row, rollups);
    case EventTable:
        return store.appendEvent(
            {static_cast<JournalKind>(row.value(2).toInt()), readTime(row.value(1)), row.value(5).toString(),
             row.value(3).toInt(), row.value(4).toInt()});
    case GapTable: {
        const std::optional<UtcTime> to = row.isNull(3) ? std::nullopt : std::optional(readTime(row.value(3)));
        return store.putGap(
            {row.value(1).toInt(), readTime(row.value(2)), to.value_or(readTime(row.value(2))),
             static_cast<GapReason>(row.value(4).toInt()), row.value(5).toString()});
    }
    case RecordTable:
        return store.putRecord(
            {row.value(1).toInt(), readTime(row.value(2)), row.value(3).toString(), row.value(4).toByteArray()},
            &isNew);
    default: return takeTail(row, store, rollups);
    }
}

bool Salvage::takeChunk(const QSqlQuery &row, ArchiveStore &store)
{
    const QByteArray data = row.value(5).toByteArray();
    if (!ArchiveCursor::ofSealed(data).isGood()) {
        --m_rescued;
        return true;
    }
    const int number = row.value(2).toInt();
    const TimeSpan span{readTime(row.value(3)), readTime(row.value(4))};
    m_knownFrom[number] = std::min(m_knownFrom.value(number, span.from), span.from);
    return store.appendChunk(static_cast<ChunkKind>(row.value(1).toInt()), number, span, data);
}

bool Salvage::takeRollup(const QSqlQuery &row, RollupBook &rollups)
{
    const auto kind = static_cast<ChunkKind>(row.value(1).toInt());
    const auto buckets = decodeRollup(row.value(5).toByteArray(), kind);
    if (!buckets) {
        --m_rescued;
        return true;
    }
    const SeriesKey key{row.value(2).toInt(), static_cast<Quantity>(row.value(3).toInt())};
    return rollups.add(kind, key, *buckets, m_offsets.value(key.number).of(key.quantity));
}

bool Salvage::takeTail(const QSqlQuery &row, ArchiveStore &store, RollupBook &rollups)
{
    const qint64 id = row.value(0).toLongLong();
    const auto contents = TailBatch::decode(row.value(1).toByteArray());
    OpenChunks open;
    for (const KeptReading &reading : contents ? contents->readings : QList<KeptReading>()) {
        if (id > m_known.value(reading.number).readingsDone) {
            open.add(reading, id);
        }
    }
    for (const SampleBlock &block : contents ? contents->blocks : QList<SampleBlock>()) {
        if (id > m_known.value(block.number).samplesDone) {
            open.add(block, id);
        }
    }
    for (const auto &[number, sensor] : open.sensors()) {
        const ValueOffsets offsets = m_offsets.value(number);
        for (const ReadingChunk &chunk : sensor.readings.chunks) {
            if (!store.appendChunk(ChunkKind::FullRate, number, spanOf(chunk), encodeChunk(chunk, offsets))
                || !rollups.add(number, chunk, offsets)) {
                return false;
            }
        }
        for (const SampleChunk &chunk : sensor.samples.chunks) {
            if (!store.appendChunk(ChunkKind::Samples, number, spanOf(chunk), encodeChunk(chunk))
                || !rollups.add(number, chunk)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace gorizont
