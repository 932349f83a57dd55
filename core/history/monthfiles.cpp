#include "core/history/monthfiles.h"

#include <QDir>

#include <algorithm>

namespace gorizont {

QStringList monthFiles(const QString &folder, MonthFile kind)
{
    const QString pattern =
        kind == MonthFile::Data ? QStringLiteral("????_??_data.txt") : QStringLiteral("????_??_adata.txt");
    QStringList paths;
    for (const QFileInfo &file : QDir(folder).entryInfoList({pattern}, QDir::Files, QDir::Name)) {
        paths += file.filePath();
    }
    return paths;
}

QList<int> historyColumns(const QList<SensorConfig> &sensors, MonthFile kind)
{
    QList<int> numbers;
    for (const SensorConfig &sensor : sensors) {
        if (kind == MonthFile::Data ? sensor.measuresTilt : sensor.measuresAcceleration) {
            numbers.append(sensor.number);
        }
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

} // namespace gorizont
