#pragma once

#include <QByteArray>

#include <optional>

namespace gorizont {

/// A message that waits for the broker.
struct QueuedMessage
{
    quint64 sequence = 0; ///< rises by one with each message, also over restarts
    QByteArray topic; ///< without the prefix: `sensor/3/reading`, no blanks
    QByteArray payload; ///< JSON in one line

    bool operator==(const QueuedMessage &) const = default;
};

/// One line of a queue file, for people to read too: check sum, number, topic, payload. Pure.
///
///     a1f0 1767225600000000 sensor/3/reading {"number":3,…}␊
///
/// The check sum is CRC-16/X-25 (ISO 3309) of what follows the blank after it, without the line feed, as four hex
/// digits.
QByteArray encodeRecord(const QueuedMessage &message);

/// \a line without its line feed. Empty: it is not a whole record.
std::optional<QueuedMessage> parseRecord(QByteArrayView line);

} // namespace gorizont
