#pragma once

#include "core/mqtt/messagequeue.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace gorizont::test {

using namespace std::chrono_literals;

inline constexpr UtcTime firstStart{std::chrono::microseconds(5000)};

/// A folder, what the queue told, and a new queue on the folder as after a start of the program.
struct QueueBench
{
    explicit QueueBench(MessageQueue::Limits given = {})
        : limits(given)
    {
        start();
    }

    void start()
    {
        queue.reset();
        queue.emplace(folder.filePath(QStringLiteral("Mqtt")), limits, [this](JournalKind kind, const QString &text) {
            told.append(QString::number(static_cast<int>(kind)) + u' ' + text);
        });
        queue->open(firstStart);
    }

    void append(int count, int payloadSize = 20)
    {
        QList<QueuedMessage> messages;
        for (int i = 0; i < count; ++i) {
            const quint64 sequence = queue->nextSequence() + static_cast<quint64>(i);
            const QByteArray payload = QByteArray::number(sequence).rightJustified(payloadSize, '-');
            messages.append({sequence, QByteArrayLiteral("sensor/1/reading"), payload});
        }
        queue->append(messages);
    }

    /// The numbers that next() gives until it has nothing; the payload must be the one of the number.
    QList<quint64> takeAll()
    {
        QList<quint64> numbers;
        while (const auto message = queue->next()) {
            const bool isOwn = message->payload.endsWith(QByteArray::number(message->sequence));
            numbers.append(isOwn ? message->sequence : 0);
        }
        return numbers;
    }

    QStringList fileNames() const
    {
        return QDir(folder.filePath(QStringLiteral("Mqtt"))).entryList({QStringLiteral("queue-*")}, QDir::Files);
    }
    QString pathOf(qsizetype index) const
    {
        return folder.filePath(QStringLiteral("Mqtt/")) + fileNames().value(index);
    }
    QByteArray bytesOf(qsizetype index) const
    {
        QFile file(pathOf(index));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void overwrite(qsizetype index, const QByteArray &bytes) const
    {
        QFile file(pathOf(index));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    QTemporaryDir folder;
    MessageQueue::Limits limits;
    QStringList told;
    std::optional<MessageQueue> queue;
};

inline QList<quint64> numbers(quint64 first, quint64 last)
{
    QList<quint64> all;
    for (quint64 number = first; number <= last; ++number) {
        all.append(number);
    }
    return all;
}

inline MessageQueue::Limits small(qint64 bytes, qint64 segmentBytes)
{
    MessageQueue::Limits limits;
    limits.bytes = bytes;
    limits.segmentBytes = segmentBytes;
    limits.retry = 0ms;
    return limits;
}

} // namespace gorizont::test
