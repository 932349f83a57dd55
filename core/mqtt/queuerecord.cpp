#include "core/mqtt/queuerecord.h"

namespace gorizont {

namespace {

constexpr qsizetype checksumDigits = 4;

QByteArray checksum(QByteArrayView text)
{
    return QByteArray::number(qChecksum(text, Qt::ChecksumIso3309), 16).rightJustified(checksumDigits, '0');
}

} // namespace

QByteArray encodeRecord(const QueuedMessage &message)
{
    const QByteArray text = QByteArray::number(message.sequence) + ' ' + message.topic + ' ' + message.payload;
    return checksum(text) + ' ' + text + '\n';
}

std::optional<QueuedMessage> parseRecord(QByteArrayView line)
{
    if (line.size() <= checksumDigits || line.at(checksumDigits) != ' ') {
        return std::nullopt;
    }
    const QByteArrayView text = line.sliced(checksumDigits + 1);
    if (line.first(checksumDigits) != checksum(text)) {
        return std::nullopt;
    }
    const qsizetype afterNumber = text.indexOf(' ');
    const qsizetype afterTopic = afterNumber < 0 ? -1 : text.indexOf(' ', afterNumber + 1);
    if (afterTopic < 0) {
        return std::nullopt;
    }
    bool isNumber = false;
    QueuedMessage message;
    message.sequence = text.first(afterNumber).toByteArray().toULongLong(&isNumber);
    message.topic = text.sliced(afterNumber + 1, afterTopic - afterNumber - 1).toByteArray();
    message.payload = text.sliced(afterTopic + 1).toByteArray();
    return isNumber ? std::optional(message) : std::nullopt;
}

} // namespace gorizont
