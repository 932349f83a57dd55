#include "core/archive/tailbatch.h"

#include "core/archive/archivebytes.h"
#include "core/archive/chunkkind.h"
#include "core/archive/integercolumn.h"

#include <limits>
#include <utility>

namespace gorizont {

namespace {

enum Item : quint8 { ReadingItem = 1, BlockItem = 2 };

QByteArray item(Item kind, int number, const ArchiveBytes &content)
{
    ArchiveBytes bytes;
    bytes.byte(kind);
    bytes.number(static_cast<quint64>(number));
    bytes.piece(content.bytes());
    return bytes.bytes();
}

UtcTime takeTime(ArchiveCursor &cursor)
{
    constexpr qint64 farthest = qint64{1} << 60;
    const qint64 time = cursor.signedNumber();
    if (time < -farthest || time > farthest) {
        cursor.fail();
    }
    return UtcTime(std::chrono::microseconds(time));
}

KeptReading takeReading(ArchiveCursor &cursor, int number)
{
    KeptReading reading{number, takeTime(cursor), {}};
    while (cursor.isGood() && !cursor.isAtEnd()) {
        KeptValue value;
        value.quantity = static_cast<Quantity>(cursor.byte());
        if (cursor.byte() != 0) {
            value.value = cursor.real();
        }
        reading.values.append(value);
    }
    return reading;
}

QList<qint16> takeSamples(ArchiveCursor &cursor, quint64 count)
{
    QList<qint16> samples;
    for (quint64 i = 0; i < count && cursor.isGood(); ++i) {
        const qint64 sample = cursor.signedNumber();
        if (sample < std::numeric_limits<qint16>::min() || sample > std::numeric_limits<qint16>::max()) {
            cursor.fail();
        }
        samples.append(static_cast<qint16>(sample));
    }
    return samples;
}

SampleBlock takeBlock(ArchiveCursor &cursor, int number)
{
    SampleBlock block;
    block.number = number;
    block.start = takeTime(cursor);
    block.followsPrevious = cursor.byte() != 0;
    block.rate = cursor.real();
    block.scale = cursor.real();
    const quint64 count = cursor.number();
    if (count == 0 || count > mostInColumn || !(block.rate >= 1e-3) || !(block.rate <= 1e6)) {
        cursor.fail();
    }
    block.x = takeSamples(cursor, count);
    block.y = takeSamples(cursor, count);
    if (!cursor.isAtEnd()) {
        cursor.fail();
    }
    return block;
}

} // namespace

void TailBatch::add(const KeptReading &reading)
{
    ArchiveBytes content;
    content.signedNumber(reading.time.time_since_epoch().count());
    for (const KeptValue &kept : reading.values) {
        content.byte(static_cast<quint8>(kept.quantity));
        content.byte(kept.value ? 1 : 0);
        if (kept.value) {
            content.real(*kept.value);
        }
    }
    m_items += item(ReadingItem, reading.number, content);
}

void TailBatch::add(const SampleBlock &block)
{
    ArchiveBytes content;
    content.signedNumber(block.start.time_since_epoch().count());
    content.byte(block.followsPrevious ? 1 : 0);
    content.real(block.rate);
    content.real(block.scale);
    const qsizetype count = std::min(block.x.size(), block.y.size());
    content.number(static_cast<quint64>(count));
    for (const QList<qint16> *axis : {&block.x, &block.y}) {
        for (qsizetype i = 0; i < count; ++i) {
            content.signedNumber(axis->at(i));
        }
    }
    m_items += item(BlockItem, block.number, content);
}

QByteArray TailBatch::take()
{
    ArchiveBytes bytes;
    bytes.byte(chunkVersion);
    bytes.raw(std::exchange(m_items, {}));
    return bytes.sealed();
}

std::optional<TailBatch::Contents> TailBatch::decode(QByteArrayView bytes, const QSet<int> &only)
{
    ArchiveCursor cursor = ArchiveCursor::ofSealed(bytes);
    if (cursor.byte() != chunkVersion) {
        return {};
    }
    Contents contents;
    while (cursor.isGood() && !cursor.isAtEnd()) {
        const quint8 kind = cursor.byte();
        const quint64 number = cursor.number();
        ArchiveCursor piece(cursor.piece());
        if (!cursor.isGood() || number > std::numeric_limits<int>::max()
            || (kind != ReadingItem && kind != BlockItem)) {
            return {};
        }
        if (!only.isEmpty() && !only.contains(static_cast<int>(number))) {
            continue;
        }
        if (kind == ReadingItem) {
            contents.readings.append(takeReading(piece, static_cast<int>(number)));
        } else {
            contents.blocks.append(takeBlock(piece, static_cast<int>(number)));
        }
        if (!piece.isGood()) {
            return {};
        }
    }
    return cursor.isGood() ? std::optional(std::move(contents)) : std::nullopt;
}

} // namespace gorizont
