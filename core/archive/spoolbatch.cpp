#include "core/archive/spoolbatch.h"

#include "core/archive/archivebytes.h"
#include "core/archive/tailbatch.h"

namespace gorizont {

namespace {

enum BatchVersion : quint8 { Plain = 1, WithBackfills = 2 };

void putTime(ArchiveBytes &bytes, UtcTime time)
{
    bytes.signedNumber(time.time_since_epoch().count());
}

UtcTime takeTime(ArchiveCursor &cursor)
{
    return UtcTime(std::chrono::microseconds(cursor.signedNumber()));
}

void putTime(ArchiveBytes &bytes, const std::optional<UtcTime> &time)
{
    bytes.byte(time ? 1 : 0);
    if (time) {
        putTime(bytes, *time);
    }
}

std::optional<UtcTime> takeOptionalTime(ArchiveCursor &cursor)
{
    return cursor.byte() != 0 ? std::optional(takeTime(cursor)) : std::nullopt;
}

template <typename Batch> QByteArray valuesOf(const Batch &batch)
{
    TailBatch values;
    for (const KeptReading &reading : batch.readings) {
        values.add(reading);
    }
    for (const SampleBlock &block : batch.blocks) {
        values.add(block);
    }
    return values.isEmpty() ? QByteArray() : values.take();
}

template <typename Batch> bool takeValues(ArchiveCursor &cursor, Batch &batch)
{
    const QByteArrayView bytes = cursor.piece();
    if (bytes.isEmpty()) {
        return cursor.isGood();
    }
    auto values = TailBatch::decode(bytes);
    if (values) {
        batch.readings = std::move(values->readings);
        batch.blocks = std::move(values->blocks);
    }
    return values.has_value();
}

JournalEntry takeEntry(ArchiveCursor &cursor)
{
    JournalEntry entry;
    entry.kind = static_cast<JournalKind>(cursor.byte());
    entry.time = takeTime(cursor);
    entry.port = static_cast<int>(cursor.signedNumber());
    entry.number = static_cast<int>(cursor.signedNumber());
    entry.text = QString::fromUtf8(cursor.piece());
    return entry;
}

Gap takeGap(ArchiveCursor &cursor)
{
    Gap gap;
    gap.number = static_cast<int>(cursor.number());
    gap.from = takeTime(cursor);
    gap.to = takeOptionalTime(cursor);
    gap.reason = static_cast<GapReason>(cursor.byte());
    gap.filledFrom = QString::fromUtf8(cursor.piece());
    return gap;
}

void putBackfill(ArchiveBytes &bytes, const Backfill &backfill)
{
    bytes.number(static_cast<quint64>(backfill.number));
    bytes.piece(backfill.source.toUtf8());
    bytes.number(static_cast<quint64>(backfill.period.count()));
    bytes.piece(valuesOf(backfill));
    bytes.number(static_cast<quint64>(backfill.records.size()));
    for (const DeviceRecord &record : backfill.records) {
        putTime(bytes, record.start);
        bytes.piece(record.name.toUtf8());
        bytes.piece(record.data);
    }
}

std::optional<Backfill> takeBackfill(ArchiveCursor &cursor)
{
    Backfill backfill;
    backfill.number = static_cast<int>(cursor.number());
    backfill.source = QString::fromUtf8(cursor.piece());
    backfill.period = std::chrono::microseconds(static_cast<qint64>(cursor.number()));
    if (!takeValues(cursor, backfill)) {
        return {};
    }
    for (quint64 left = cursor.number(); left > 0 && cursor.isGood(); --left) {
        const UtcTime start = takeTime(cursor);
        const QString name = QString::fromUtf8(cursor.piece());
        backfill.records.append({backfill.number, start, name, cursor.piece().toByteArray()});
    }
    return backfill;
}

} // namespace

QByteArray ArchiveBatch::encode() const
{
    ArchiveBytes bytes;
    bytes.byte(backfills.isEmpty() ? Plain : WithBackfills);
    putTime(bytes, time);
    putTime(bytes, startedAt);
    bytes.piece(valuesOf(*this));
    bytes.number(static_cast<quint64>(entries.size()));
    for (const JournalEntry &entry : entries) {
        bytes.byte(static_cast<quint8>(entry.kind));
        putTime(bytes, entry.time);
        bytes.signedNumber(entry.port);
        bytes.signedNumber(entry.number);
        bytes.piece(entry.text.toUtf8());
    }
    bytes.number(static_cast<quint64>(gaps.size()));
    for (const Gap &gap : gaps) {
        bytes.number(static_cast<quint64>(gap.number));
        putTime(bytes, gap.from);
        putTime(bytes, gap.to);
        bytes.byte(static_cast<quint8>(gap.reason));
        bytes.piece(gap.filledFrom.toUtf8());
    }
    if (!backfills.isEmpty()) {
        bytes.number(static_cast<quint64>(backfills.size()));
        for (const Backfill &backfill : backfills) {
            putBackfill(bytes, backfill);
        }
    }
    return bytes.bytes();
}

std::optional<ArchiveBatch> ArchiveBatch::decode(QByteArrayView bytes)
{
    ArchiveCursor cursor(bytes);
    const quint8 version = cursor.byte();
    if (version != Plain && version != WithBackfills) {
        return {};
    }
    ArchiveBatch batch;
    batch.time = takeTime(cursor);
    batch.startedAt = takeOptionalTime(cursor);
    if (!takeValues(cursor, batch)) {
        return {};
    }
    for (quint64 left = cursor.number(); left > 0 && cursor.isGood(); --left) {
        batch.entries.append(takeEntry(cursor));
    }
    for (quint64 left = cursor.number(); left > 0 && cursor.isGood(); --left) {
        batch.gaps.append(takeGap(cursor));
    }
    for (quint64 left = version == Plain ? 0 : cursor.number(); left > 0 && cursor.isGood(); --left) {
        const auto backfill = takeBackfill(cursor);
        if (!backfill) {
            return {};
        }
        batch.backfills.append(*backfill);
    }
    return cursor.isGood() && cursor.isAtEnd() ? std::optional(std::move(batch)) : std::nullopt;
}

} // namespace gorizont
