#pragma once

#include "core/mqtt/queuerecord.h"
#include "core/mqtt/segmentfiles.h"
#include "core/values/journalentry.h"

#include <QCoreApplication>

#include <functional>

namespace gorizont {

/// What waits for the broker, in order. It lies on the disk, so that killing the program loses nothing of it, and is
/// bounded there: beyond the limit the oldest file of it goes. What the disk does not take waits in memory, bounded
/// too. Lives in the thread of the publisher, which a slow disk may hold up.
class MessageQueue
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::MessageQueue)

public:
    using Note = std::function<void(JournalKind, const QString &)>;

    struct Limits
    {
        qint64 bytes = 64 << 20; ///< on the disk
        qint64 segmentBytes = 1 << 20; ///< what goes at once when there is no room
        qsizetype memoryBytes = 4 << 20; ///< that the disk did not take
        std::chrono::milliseconds retry{3000}; ///< after a failure the disk is asked this often

        static Limits of(qint64 bytes);
    };

    MessageQueue(const QString &folder, const Limits &limits, Note note);

    /// Takes over what an earlier run left. In a new folder the numbers begin at \a now, in microseconds, so that they
    /// rise for a receiver even if somebody removed the folder.
    void open(UtcTime now);

    quint64 nextSequence() const { return m_nextSequence; }
    /// Their numbers are nextSequence() and those that follow.
    void append(const QList<QueuedMessage> &messages);
    /// Asks the disk again to take what it did not take.
    void save();

    /// The oldest message that was not handed out yet; empty: there is none.
    std::optional<QueuedMessage> next();
    /// next() begins again at the oldest message.
    void rewind();
    /// The broker has everything up to \a sequence.
    void acknowledge(quint64 sequence);

    quint64 waiting() const; ///< messages
    qint64 bytesOnDisk() const { return m_files.bytes(); }
    quint64 lost() const { return m_lost; } ///< messages, since the start of the program

private:
    struct Position
    {
        quint64 segment = 0; ///< its first
        qint64 at = 0; ///< of the next byte
    };

    bool readSome();
    void parseLines(const QByteArray &bytes);
    std::optional<QueuedMessage> nextInMemory() const;
    void restoreMark();
    void saveMark();
    void keepLimits();
    void giveUp(quint64 count);
    void noteDamage(quint64 count);

    const QString m_folder;
    const Limits m_limits;
    const Note m_note;
    SegmentFiles m_files;
    std::deque<QueuedMessage> m_unsaved; ///< follows what is in the files
    qsizetype m_unsavedBytes = 0;
    quint64 m_nextSequence = 0;
    quint64 m_acknowledged = 0; ///< everything below is with the broker, or lost
    quint64 m_nextOut = 0; ///< everything below was handed out
    Position m_position; ///< of reading
    quint64 m_expected = 0; ///< the number of the next record there
    std::deque<QueuedMessage> m_ready; ///< read and not handed out
    QFile m_mark; ///< holds m_acknowledged
    std::optional<SteadyTime> m_retryAt; ///< the disk failed
    quint64 m_lost = 0;
    quint64 m_lostUntold = 0;
};

} // namespace gorizont
