#include "app/configfile.h"

#include "core/config/inifile.h"

#include <QCoreApplication>
#include <QFile>

namespace gorizont {

namespace {

/// A configuration has some kilobytes; a file of this size was chosen by mistake.
constexpr qint64 largestFile = 64'000'000; ///< bytes

} // namespace

std::optional<ConfigReading> readConfigFile(const QString &path, QString *why)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        *why = file.errorString();
        return std::nullopt;
    }
    // Not by its size: a device or a pipe says none.
    const QByteArray bytes = file.read(largestFile + 1);
    if (bytes.size() > largestFile) {
        *why = QCoreApplication::translate("gorizont::ConfigFile", "the file is far too large to be a configuration");
        return std::nullopt;
    }
    return readServerConfig(IniFile::fromBytes(bytes));
}

} // namespace gorizont
