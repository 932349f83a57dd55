#include "core/history/samplerepair.h"

#include <QDir>
#include <QDirIterator>
#include <QHash>
#include <QRegularExpression>

#include <algorithm>

namespace gorizont {

namespace {

/// Sensor number → the newest `16_03_29_22_46_09_1`; the names sort as their times do.
QHash<QString, QString> newestPairs(const QString &folder)
{
    static const QRegularExpression pattern(QStringLiteral(R"(^((?:\d\d_){6}(\d+))[XY]\.wrd$)"));
    QHash<QString, QString> newest;
    QDirIterator files(folder, QDir::Files);
    while (files.hasNext()) {
        files.next();
        const QRegularExpressionMatch match = pattern.match(files.fileName());
        if (match.hasMatch()) {
            QString &pair = newest[match.captured(2)];
            pair = std::max(pair, match.captured(1));
        }
    }
    return newest;
}

void resize(const QString &path, qint64 size, QStringList &changed)
{
    const QFileInfo file(path);
    if (file.size() != size && QFile::resize(path, size)) {
        changed.append(file.fileName());
    }
    if (size == 0 && QFile::remove(path) && !changed.contains(file.fileName())) {
        changed.append(file.fileName());
    }
}

/// A file whose partner is missing is left alone if it holds anything: that was not us.
void repairPair(const QString &stem, QStringList &changed)
{
    const QString pathX = stem + QStringLiteral("X.wrd");
    const QString pathY = stem + QStringLiteral("Y.wrd");
    const qint64 sizeX = QFileInfo(pathX).size(); // 0 for a file that does not exist
    const qint64 sizeY = QFileInfo(pathY).size();
    if (QFile::exists(pathX) != QFile::exists(pathY) && sizeX + sizeY > 0) {
        return;
    }
    const qint64 size = std::min(sizeX, sizeY) / 2 * 2;
    resize(pathX, size, changed);
    resize(pathY, size, changed);
}

} // namespace

QStringList repairSampleFiles(const QString &folder)
{
    QStringList changed;
    const QHash<QString, QString> pairs = newestPairs(folder);
    for (const QString &pair : pairs) {
        repairPair(folder + u'/' + pair, changed);
    }
    changed.sort();
    return changed;
}

} // namespace gorizont
