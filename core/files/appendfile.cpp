#include "core/files/appendfile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#include <unistd.h>
#else
#include <io.h>
#endif

namespace gorizont {

bool AppendFile::open(const QString &path, Mode mode)
{
    close();
    const QString folder = QFileInfo(path).path();
    if (!QDir().mkpath(folder)) {
        m_error = QCoreApplication::translate("AppendFile", "the folder %1 cannot be created")
                      .arg(QDir::toNativeSeparators(folder));
        return false;
    }
    m_file.setFileName(path);
    QIODevice::OpenMode flags = QIODevice::ReadWrite | QIODevice::Append | QIODevice::Unbuffered;
    flags.setFlag(QIODevice::NewOnly, mode == Mode::New);
    if (!m_file.open(flags)) {
        return fail();
    }
    m_size = m_file.size();
    return true;
}

bool AppendFile::append(QByteArrayView bytes)
{
    qint64 written = 0;
    while (written < bytes.size()) { // a second round only after a short write: it brings the reason
        const qint64 count = m_file.write(bytes.data() + written, bytes.size() - written);
        if (count <= 0) {
            break;
        }
        written += count;
    }
    if (written == bytes.size()) {
        m_size += written;
        return true;
    }
    fail();
    m_file.resize(m_size); // if even this fails, whoever opens the file next repairs it
    return false;
}

bool AppendFile::sync()
{
#ifdef Q_OS_UNIX
    const bool isDone = ::fsync(m_file.handle()) == 0;
#else
    const bool isDone = ::_commit(m_file.handle()) == 0;
#endif
    if (!isDone) {
        m_error = QFileInfo(path()).fileName() + QStringLiteral(": ") + qt_error_string();
    }
    return isDone;
}

bool AppendFile::cut(qint64 size)
{
    if (!m_file.resize(size)) {
        return fail();
    }
    m_size = size;
    return true;
}

QByteArray AppendFile::read(qint64 at, qint64 count)
{
    const QByteArray bytes = m_file.seek(at) ? m_file.read(count) : QByteArray();
    if (bytes.size() != count) {
        fail();
    }
    return bytes;
}

bool AppendFile::isInPlace() const
{
#ifdef Q_OS_UNIX
    struct stat opened = {};
    struct stat found = {};
    return ::fstat(m_file.handle(), &opened) == 0 && ::stat(QFile::encodeName(path()).constData(), &found) == 0
        && opened.st_dev == found.st_dev && opened.st_ino == found.st_ino && opened.st_size == m_size;
#else
    return QFileInfo(path()).size() == m_size;
#endif
}

bool AppendFile::fail()
{
    m_error = QFileInfo(path()).fileName() + QStringLiteral(": ") + m_file.errorString();
    return false;
}

} // namespace gorizont
