#include "core/protocol/ackframe.h"

#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"

#include <algorithm>

namespace gorizont::ack {

namespace {

void appendCheckSum(QByteArray &bytes)
{
    appendByte(bytes, -byteSum(bytes));
}

/// From the first byte on that may begin a frame \a blockLength knows.
Scan scanFrom(QByteArrayView bytes, qsizetype from, const BlockLength &blockLength)
{
    for (qsizetype at = from; at < bytes.size(); ++at) {
        if (byteAt(bytes, at) != startByte) {
            continue;
        }
        const QByteArrayView rest = bytes.sliced(at);
        if (rest.size() < headerSize) {
            return Scan::incomplete(at);
        }
        const auto header = readHeader(rest);
        const auto length = header ? blockLength(*header) : std::nullopt;
        if (!length) {
            continue;
        }
        if (rest.size() < headerSize + *length) {
            return Scan::incomplete(at);
        }
        if (*length == 0 || isBlockGood(rest.sliced(headerSize, *length))) {
            return Scan::complete(at, headerSize + *length);
        }
        return Scan::damaged(at, headerSize + *length);
    }
    return Scan::incomplete(bytes.size());
}

} // namespace

QByteArray encodeHeader(const Header &header)
{
    QByteArray bytes;
    bytes.reserve(headerSize);
    appendByte(bytes, startByte);
    appendByte(bytes, header.address);
    appendByte(bytes, header.command);
    appendByte(bytes, header.length);
    appendLittle<quint32>(bytes, header.digital);
    appendCheckSum(bytes);
    return bytes;
}

QByteArray encodeBlock(const QByteArray &block)
{
    QByteArray bytes = block;
    appendCheckSum(bytes);
    return bytes;
}

std::optional<Header> readHeader(QByteArrayView bytes)
{
    if (bytes.size() < headerSize || byteAt(bytes, 0) != startByte || byteSum(bytes.first(headerSize)) != 0) {
        return std::nullopt;
    }
    return Header{byteAt(bytes, 1), byteAt(bytes, 2), byteAt(bytes, 3), readLittle<quint32>(bytes, 4).value_or(0)};
}

bool isBlockGood(QByteArrayView block)
{
    return !block.isEmpty() && byteSum(block) == 0;
}

Scan scanFrame(QByteArrayView bytes, const BlockLength &blockLength)
{
    const Scan first = scanFrom(bytes, 0, blockLength);
    if (first.state != Scan::State::Damaged) {
        return first;
    }
    const Scan next = scanFrom(bytes, first.skip + 1, blockLength);
    return Scan::damaged(first.skip, std::min(first.length, next.skip - first.skip));
}

} // namespace gorizont::ack
