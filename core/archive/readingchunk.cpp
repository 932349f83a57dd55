#include "core/archive/readingchunk.h"

#include "core/archive/archivebytes.h"
#include "core/archive/chunkkind.h"
#include "core/archive/integercolumn.h"
#include "core/archive/timecolumn.h"
#include "core/archive/valuecolumn.h"

#include <algorithm>

namespace gorizont {

namespace {

void appendColumn(ArchiveBytes &bytes, const ValueColumn &column, double offset)
{
    ArchiveBytes piece;
    if (std::find(column.isValid.begin(), column.isValid.end(), false) == column.isValid.end()) {
        piece.byte(0);
        appendValues(piece, column.values, offset);
    } else {
        piece.byte(1);
        appendIntegers(piece, std::vector<qint64>(column.isValid.begin(), column.isValid.end()));
        std::vector<double> valid;
        for (std::size_t i = 0; i < column.values.size(); ++i) {
            if (column.isValid[i]) {
                valid.push_back(column.values[i]);
            }
        }
        appendValues(piece, valid, offset);
    }
    bytes.byte(static_cast<quint8>(column.quantity));
    bytes.piece(piece.bytes());
}

bool takeValidity(ArchiveCursor &cursor, ValueColumn &column, std::size_t count)
{
    const quint8 form = cursor.byte();
    if (form == 0) {
        column.isValid.assign(count, true);
        return cursor.isGood();
    }
    for (const qint64 one : takeIntegers(cursor, count)) {
        column.isValid.push_back(one != 0);
    }
    return cursor.isGood() && form == 1;
}

bool takeColumn(ArchiveCursor cursor, ValueColumn &column, std::size_t count)
{
    if (!takeValidity(cursor, column, count)) {
        return false;
    }
    const auto valid = static_cast<quint64>(std::count(column.isValid.begin(), column.isValid.end(), true));
    std::vector<double> values = takeValues(cursor, valid);
    if (!cursor.isGood() || !cursor.isAtEnd()) {
        return false;
    }
    if (valid == count) {
        column.values = std::move(values);
        return true;
    }
    auto next = values.begin();
    column.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        column.values.push_back(column.isValid[i] ? *next++ : 0);
    }
    return true;
}

} // namespace

void ReadingChunk::append(const KeptReading &reading)
{
    auto place = columns.begin();
    for (const KeptValue &kept : reading.values) {
        place =
            std::find_if(place, columns.end(), [&kept](const ValueColumn &c) { return c.quantity >= kept.quantity; });
        if (place == columns.end() || place->quantity != kept.quantity) {
            place =
                columns.insert(place, {kept.quantity, std::vector<double>(size()), std::vector<bool>(size(), false)});
        }
        place->values.push_back(kept.value.value_or(0));
        place->isValid.push_back(kept.value.has_value());
    }
    times.push_back(reading.time);
    for (ValueColumn &column : columns) {
        column.values.resize(size());
        column.isValid.resize(size(), false);
    }
}

const ValueColumn *ReadingChunk::column(Quantity quantity) const
{
    const auto found = std::find_if(columns.begin(), columns.end(), [quantity](const ValueColumn &column) {
        return column.quantity == quantity;
    });
    return found == columns.end() ? nullptr : &*found;
}

double ValueOffsets::of(Quantity quantity) const
{
    switch (quantity) {
    case Quantity::TiltX: return x;
    case Quantity::TiltY: return y;
    case Quantity::Temperature: return temperature;
    default: return 0;
    }
}

QByteArray encodeChunk(const ReadingChunk &chunk, const ValueOffsets &offsets)
{
    ArchiveBytes bytes;
    bytes.byte(chunkVersion);
    bytes.byte(static_cast<quint8>(ChunkKind::FullRate));
    bytes.number(chunk.times.size());
    appendTimes(bytes, chunk.times);
    bytes.number(chunk.columns.size());
    for (const ValueColumn &column : chunk.columns) {
        appendColumn(bytes, column, offsets.of(column.quantity));
    }
    return bytes.sealed();
}

std::optional<ReadingChunk> decodeReadingChunk(QByteArrayView bytes, std::optional<Quantity> only)
{
    ArchiveCursor cursor = ArchiveCursor::ofSealed(bytes);
    const quint64 count = takeChunkHead(cursor, ChunkKind::FullRate);
    ReadingChunk chunk;
    chunk.times = takeTimes(cursor, count);
    const quint64 columns = cursor.number();
    quint8 before = 0;
    for (quint64 i = 0; i < columns && cursor.isGood(); ++i) {
        const quint8 quantity = cursor.byte();
        const QByteArrayView piece = cursor.piece();
        if (!cursor.isGood() || quantity <= before) {
            return {};
        }
        before = quantity;
        ValueColumn column;
        column.quantity = static_cast<Quantity>(quantity);
        if (only && *only != column.quantity) {
            continue;
        }
        if (!takeColumn(ArchiveCursor(piece), column, chunk.times.size())) {
            return {};
        }
        chunk.columns.push_back(std::move(column));
    }
    return cursor.isGood() && cursor.isAtEnd() ? std::optional(std::move(chunk)) : std::nullopt;
}

} // namespace gorizont
