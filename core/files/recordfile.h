#pragma once

#include "core/files/appendfile.h"

#include <utility>

namespace gorizont {

/// A text file of records that end with a line feed, one write each. Whatever happened to the last record (killed, power
/// cut, full disk), the next one begins on a line of its own.
class RecordFile
{
public:
    enum class State : quint8 { Failed, Ready, Opened };

    /// Makes \a path the file that is open. Opened: it was opened just now, because another one was open before or
    /// because somebody removed, replaced or changed it; its last record is whole now.
    State prepare(const QString &path);

    /// To the file that is prepared: all of \a record or, with false, nothing.
    bool append(QByteArrayView record);

    void close() { m_file.close(); }
    QString path() const { return m_file.path(); }
    QString error() const { return m_file.error(); }

    /// True once after an unfinished record was cut off.
    bool takeRepaired() { return std::exchange(m_wasRepaired, false); }

    /// What the whole file holds is valid UTF-8.
    bool isUtf8();

private:
    bool cutUnfinishedRecord();

    AppendFile m_file;
    bool m_wasRepaired = false;
};

} // namespace gorizont
