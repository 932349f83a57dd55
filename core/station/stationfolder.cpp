#include "core/station/stationfolder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

constexpr qint64 longestFile = 1 << 20; ///< bytes

/// Empty: \a bytes hold the file.
QString problemOf(const QString &path, QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return Station::tr("The file cannot be read (%1).").arg(file.errorString());
    }
    if (file.size() > longestFile) {
        return Station::tr("The file is longer than 1 MiB.");
    }
    bytes = file.readAll();
    return file.error() == QFile::NoError ? QString()
                                          : Station::tr("The file cannot be read (%1).").arg(file.errorString());
}

} // namespace

StationFiles readStationFolder(const QString &folder, QList<StationComplaint> &complaints)
{
    StationFiles files;
    const QDir directory(folder);
    if (!directory.exists()) {
        complaints.append(
            {folder, 0, 0, {}, Station::tr("The folder does not exist."), Station::tr("Nothing is measured.")});
        return files;
    }
    const QStringList names = directory.entryList(QDir::Files | QDir::Hidden, QDir::Name);
    for (const QString &name : names) {
        const QString canonical = canonicalName(name);
        if (canonical.isEmpty()) {
            continue;
        }
        const QString leftOut = Station::tr("The file is not used.");
        if (files.contains(canonical)) {
            complaints.append(
                {name, 0, 0, {}, Station::tr("Another file of the folder is %1 already.").arg(canonical), leftOut});
            continue;
        }
        QByteArray bytes;
        const QString problem = problemOf(directory.filePath(name), bytes);
        if (problem.isEmpty()) {
            files.insert(canonical, bytes);
        } else {
            complaints.append({name, 0, 0, {}, problem, leftOut});
        }
    }
    return files;
}

StationReading readStationIn(const QString &folder)
{
    QList<StationComplaint> complaints;
    const StationFiles files = readStationFolder(folder, complaints);
    StationReading reading = readStation(files);
    reading.complaints = complaints + reading.complaints;
    return reading;
}

} // namespace gorizont::station
