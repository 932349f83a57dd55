#include "core/files/recordfile.h"

#include <QStringDecoder>

namespace gorizont {

namespace {

constexpr qint64 chunkSize = 65536;

} // namespace

RecordFile::State RecordFile::prepare(const QString &path)
{
    if (m_file.isOpen() && m_file.path() == path && m_file.isInPlace()) {
        return State::Ready;
    }
    if (!m_file.open(path, AppendFile::Mode::Continue)) {
        return State::Failed;
    }
    if (!cutUnfinishedRecord()) {
        m_file.close();
        return State::Failed;
    }
    return State::Opened;
}

bool RecordFile::append(QByteArrayView record)
{
    if (m_file.append(record)) {
        return true;
    }
    m_file.close(); // the next attempt looks at the disk anew
    return false;
}

/// A line feed ends a record even without CR: a file that went through another editor is not damaged.
bool RecordFile::cutUnfinishedRecord()
{
    qint64 end = m_file.size();
    while (end > 0) {
        const qint64 begin = std::max<qint64>(0, end - chunkSize);
        const QByteArray chunk = m_file.read(begin, end - begin);
        if (chunk.size() != end - begin) {
            return false;
        }
        if (const qsizetype at = chunk.lastIndexOf('\n'); at >= 0) {
            end = begin + at + 1;
            break;
        }
        end = begin;
    }
    if (end == m_file.size()) {
        return true;
    }
    m_wasRepaired = m_file.cut(end);
    return m_wasRepaired;
}

bool RecordFile::isUtf8()
{
    QStringDecoder decoder(QStringDecoder::Utf8);
    for (qint64 at = 0; at < m_file.size() && !decoder.hasError(); at += chunkSize) {
        const QString text = decoder(m_file.read(at, std::min(chunkSize, m_file.size() - at)));
    }
    return !decoder.hasError();
}

} // namespace gorizont
