#include "core/files/wholefile.h"

#include <QDir>
#include <QSaveFile>

namespace gorizont {

/// The flush tells that the last bytes did not fit; commit() alone would not.
QString writeWholeFile(const QString &path, const QByteArray &bytes)
{
    QSaveFile file(path);
    const bool isWritten = file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush();
    if (isWritten && file.commit()) {
        return {};
    }
    return QDir::toNativeSeparators(path) + QStringLiteral(": ") + file.errorString();
}

} // namespace gorizont
