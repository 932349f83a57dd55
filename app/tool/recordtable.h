#pragma once

#include "core/devices/usmisn/usmisnrecords.h"
#include "core/files/appendfile.h"

namespace gorizont::tool {

/// The file of `usm records --csv`: begun, or continued with what it does not have yet. Every record is on the disk before the
/// next one is taken, because a device does not send as New twice what it has sent.
class RecordTable
{
public:
    /// Returns why not, a sentence; empty: it is open. A file of something else stays as it is.
    QString open(const QString &path);
    bool isOpen() const { return m_file.isOpen(); }
    /// False: see error(). A record that the file has already is not written again.
    bool add(const usmisn::Value &record);
    QString error() const { return m_file.error(); }

private:
    QString readBack();

    AppendFile m_file;
    usmisn::RecordBook m_book; ///< what the file has
};

} // namespace gorizont::tool
