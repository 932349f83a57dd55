#pragma once

#include "core/files/recordfile.h"

namespace gorizont {

/// The `_log` file of a month: UTF-8, but a file that somebody began in Windows-1251 (the original program) is continued
/// in it.
class LogFile
{
public:
    bool append(const QString &path, const QString &record);

    void close() { m_file.close(); }
    QString error() const { return m_file.error(); }
    bool takeRepaired() { return m_file.takeRepaired(); }

private:
    RecordFile m_file;
    bool m_isUtf8 = true;
};

} // namespace gorizont
