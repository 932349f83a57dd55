#pragma once

#include "core/files/appendfile.h"

#include <optional>

namespace gorizont {

/// Which batch it is: the same name and the same or a lower sequence were written before it, or it itself.
struct SpoolMark
{
    qint64 spool = 0; ///< the name of the spool, a random number
    qint64 sequence = 0; ///< 1, 2, 3 …
    bool operator==(const SpoolMark &) const = default;
};

/// Whole batches in a file that only grows while any of them is needed; when none is, it becomes empty. One thread.
/// A kill or a power cut may tear the last one; a damaged one is left out. A record, little-endian:
///
///     4 bytes `GSPL` · 4 length of the batch · 8 name of the spool · 8 sequence · 4 CRC-32 of the 20 bytes before it
///     and of the batch · the batch
class SpoolFile
{
public:
    struct Entry
    {
        SpoolMark mark;
        QByteArray batch;
        qint64 end = 0; ///< where the next one is looked for
        bool hasDamageBefore = false;
    };

    SpoolFile(const QString &path, qint64 mostBytes);

    /// Finds what an earlier run left; a torn end is cut off. False: it cannot be opened or read, see error().
    bool open();
    bool isOpen() const { return m_file.isOpen(); }

    /// The mark of the next batch, wherever it is written.
    SpoolMark next() const { return m_next; }
    /// The next batch was written elsewhere.
    void skip() { ++m_next.sequence; }

    /// As the next batch, safe from a power cut. False: nothing of it is there; see error().
    bool append(QByteArrayView batch);
    bool isEmpty() const { return m_from >= m_file.size(); }

    /// The first batch at or after \a at; empty: there is none, or isUnreadable().
    std::optional<Entry> read(qint64 at);
    /// The disk did not give what the last read() asked for; see error().
    bool isUnreadable() const { return m_isUnreadable; }
    qint64 size() const { return m_file.size(); }
    qint64 from() const { return m_from; } ///< where the first batch that is needed begins
    /// Batches that end at or before \a end are needed no more.
    void drop(qint64 end);

    QString path() const { return m_path; }
    QString error() const { return m_error; } ///< file and reason

private:
    std::optional<Entry> readAt(qint64 at);
    qint64 nextMagic(qint64 at);
    QByteArray bytesAt(qint64 at, qint64 count);
    bool fail(const QString &reason);

    const QString m_path;
    const qint64 m_mostBytes;
    AppendFile m_file;
    SpoolMark m_next;
    qint64 m_from = 0;
    bool m_isUnreadable = false;
    QString m_error;
};

} // namespace gorizont
