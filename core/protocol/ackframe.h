#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>

#include <functional>
#include <optional>

/// The frames between a dispatcher (ЦДП) and a weather station (АКП), the same in both directions (manual 004, sections 3.6 and 4;
/// spec/mk14.md, "Frames"):
///
///     0    1    2    3    4              8
///     ┌────┬────┬────┬────┬──────────────┬────┐┌───────┬────┐
///     │ BB │ADR │CMD │LEN │ DIG, 4 bytes │CS1 ││block  │CS2 │   DIG little-endian
///     └────┴────┴────┴────┴──────────────┴────┘└───────┴────┘
///
/// ADR  1…255, of the station in both directions
/// CMD  request: 1…8 data, FF file or clock; answer: 0
/// LEN  answer: number of parameters; FF: length of the file's name; 0: no block
/// DIG  request: control word of the outputs; answer: the digital inputs; FF: length of the file, or seconds since 1970
/// CS1  the sum of all nine bytes is 0 modulo 256
/// CS2  the same for the block; BB may stand anywhere in it
namespace gorizont::ack {

constexpr quint8 startByte = 0xBB;
constexpr qsizetype headerSize = 9;
constexpr quint8 transferCommand = 0xFF; ///< a file, or the clock

struct Header
{
    quint8 address = 1;
    quint8 command = 0;
    quint8 length = 0;
    quint32 digital = 0;
    bool operator==(const Header &) const = default;
};

QByteArray encodeHeader(const Header &header);
/// \a block and its check sum.
QByteArray encodeBlock(const QByteArray &block);

/// The header at the start of \a bytes. Empty: fewer than nine bytes, no BB, or the check sum is wrong.
std::optional<Header> readHeader(QByteArrayView bytes);

/// Whether the last byte of \a block is the check sum of the others; an empty one is not.
bool isBlockGood(QByteArrayView block);

/// What follows a header: empty: this is not the header that was looked for; else the length of the block with CS2, 0: none.
using BlockLength = std::function<std::optional<qsizetype>(const Header &header)>;

/// Looks for the first frame whose header \a blockLength knows. A block with a wrong check sum is Damaged up to where another
/// frame may begin inside it, so that a header which was only data hides no true frame.
Scan scanFrame(QByteArrayView bytes, const BlockLength &blockLength);

} // namespace gorizont::ack
