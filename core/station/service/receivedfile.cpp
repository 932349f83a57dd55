#include "core/station/service/receivedfile.h"

#include "core/files/wholefile.h"
#include "core/station/stationconfig.h"
#include "core/station/stationtext.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <algorithm>

namespace gorizont::station {

namespace {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::ReceivedFile)
};

/// The path of the file that means \a canonical, however it is written; a new one in capitals if there is none.
QString pathOf(const QDir &folder, const QString &canonical)
{
    const QStringList names = folder.entryList(QDir::Files, QDir::Name);
    const auto known = std::find_if(names.begin(), names.end(), [&canonical](const QString &name) {
        return canonicalName(name) == canonical;
    });
    return folder.filePath(known == names.end() ? canonical : *known);
}

/// Empty: what was at \a path is kept, or there was nothing.
QString keepOld(const QString &path)
{
    QFile old(path);
    if (!old.exists()) {
        return {};
    }
    if (!old.open(QIODevice::ReadOnly)) {
        return QDir::toNativeSeparators(path) + QStringLiteral(": ") + old.errorString();
    }
    return writeWholeFile(path + QStringLiteral(".bak"), old.readAll());
}

} // namespace

ReceivedFile storeReceivedFile(const QString &folder, const QByteArray &name, const QByteArray &text)
{
    const QString written = decodeStationText(name);
    const QString canonical = canonicalName(written); // a name with a path is none
    if (canonical.isEmpty()) {
        return {quoted(written), Text::tr("A station takes no file of this name from a line.")};
    }
    const QString path = pathOf(QDir(folder), canonical);
    QString problem = keepOld(path);
    if (problem.isEmpty()) {
        problem = writeWholeFile(path, text);
    }
    return {canonical, problem};
}

} // namespace gorizont::station
