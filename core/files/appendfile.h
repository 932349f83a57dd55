#pragma once

#include <QFile>

namespace gorizont {

/// A file that grows by whole pieces only. Every piece is one write to the system, so that killing the program loses
/// nothing of it, and a piece that does not fit on the disk leaves no trace.
class AppendFile
{
public:
    enum class Mode : quint8 { Continue, New };

    /// Creates folder and file. Mode::New fails if the file exists.
    bool open(const QString &path, Mode mode);
    void close() { m_file.close(); }
    bool isOpen() const { return m_file.isOpen(); }
    QString path() const { return m_file.fileName(); }
    qint64 size() const { return m_size; }

    /// All of \a bytes or, with false, nothing.
    bool append(QByteArrayView bytes);
    /// What was appended is safe from a power cut then.
    bool sync();
    bool cut(qint64 size);
    bool remove() { return m_file.remove(); } ///< closes it too
    QByteArray read(qint64 at, qint64 count); ///< shorter than \a count: failed

    /// False: somebody removed, replaced or changed the file since it was opened.
    bool isInPlace() const;

    /// Why the last call failed: file and reason, for the journal.
    QString error() const { return m_error; }

private:
    bool fail();

    QFile m_file;
    qint64 m_size = 0;
    QString m_error;
};

} // namespace gorizont
