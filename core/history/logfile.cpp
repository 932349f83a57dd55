#include "core/history/logfile.h"

#include <QStringEncoder>

namespace gorizont {

namespace {

QByteArray encoded(const QString &text, bool asUtf8)
{
    QStringEncoder windows("windows-1251");
    if (asUtf8 || !windows.isValid()) { // a Qt without ICU knows no Windows-1251: a readable event is better than none
        return text.toUtf8();
    }
    return windows(text);
}

} // namespace

bool LogFile::append(const QString &path, const QString &record)
{
    const RecordFile::State state = m_file.prepare(path);
    if (state == RecordFile::State::Opened) {
        m_isUtf8 = m_file.isUtf8();
    }
    return state != RecordFile::State::Failed && m_file.append(encoded(record, m_isUtf8));
}

} // namespace gorizont
