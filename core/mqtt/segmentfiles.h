#pragma once

#include "core/files/appendfile.h"

#include <deque>

namespace gorizont {

/// One file of the queue: the records first … end − 1, a few may be missing.
struct QueueSegment
{
    quint64 first = 0; ///< in the name of the file
    quint64 end = 0;
    qint64 bytes = 0;
};

/// The files `queue-00001767225600000000.txt` of one folder, each named after its first record: written at the end,
/// removed from the front. One thread.
class SegmentFiles
{
public:
    /// A segment takes no more records once it holds \a segmentBytes.
    SegmentFiles(const QString &folder, qint64 segmentBytes);

    /// Finds what an earlier run left. True: the last file did not end with a whole record; the rest was cut off.
    bool open();

    /// Records \a first … \a end − 1, all of them or, with false, nothing. \a first is not below the end of the last
    /// segment.
    bool append(const QByteArray &lines, quint64 first, quint64 end);

    /// Shorter than \a count: the file is gone or damaged.
    QByteArray read(const QueueSegment &segment, qint64 at, qint64 count) const;

    void removeOldest();

    const std::deque<QueueSegment> &segments() const { return m_segments; } ///< ascending
    qint64 bytes() const { return m_bytes; } ///< of all of them
    QString error() const { return m_tail.error(); } ///< why append() failed

private:
    QString pathOf(quint64 first) const;
    bool repairTail();
    bool beginSegment(quint64 first);

    const QString m_folder;
    const qint64 m_segmentBytes;
    std::deque<QueueSegment> m_segments;
    qint64 m_bytes = 0;
    AppendFile m_tail; ///< the last segment, while it can be written
};

} // namespace gorizont
