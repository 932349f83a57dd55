#pragma once

#include "core/protocol/scan.h"

namespace gorizont {

/// One Modbus TCP frame (MODBUS Messaging on TCP/IP Implementation Guide 1.0b, section 3.1; manual 000, 10.1 and 10.2):
///
///     0        2        4        6      7         8
///     ┌────────┬────────┬────────┬──────┬─────────┬───────────┐
///     │transact│protocol│ length │ unit │function │ data …    │   every field big-endian
///     └────────┴────────┴────────┴──────┴─────────┴───────────┘
///                                 └────── length bytes ───────┘
///
/// transaction  anything, echoed
/// protocol     0 by the guide; anything by manual 000, echoed
/// length       2…254: the unit, the function and up to 252 bytes of data. Another value leaves no way to find the next
///              frame, so the connection ends there.
struct MbapFrame
{
    quint16 transaction = 0;
    quint16 protocol = 0;
    quint8 unit = 0;
    QByteArrayView pdu; ///< function and data, 1…253 bytes of the scanned bytes
};

namespace mbap {
constexpr qsizetype lengthEnd = 6; ///< bytes up to and including the length
constexpr qsizetype headerSize = 7; ///< bytes before the PDU
constexpr qsizetype shortest = 2; ///< of the length
constexpr qsizetype longest = 254; ///< of the length
constexpr qsizetype frameLimit = lengthEnd + longest; ///< bytes of the largest frame
} // namespace mbap

/// Looks for one frame at the start of \a bytes. Damaged, already at the sixth byte, when the length is outside 2…254.
/// Nothing is ever skipped: TCP loses no bytes.
Scan scanMbap(QByteArrayView bytes);

/// The fields of a frame that scanMbap() found Complete; \a frame is all of it and nothing more.
MbapFrame readMbap(QByteArrayView frame);

} // namespace gorizont
