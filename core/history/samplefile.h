#pragma once

#include "core/files/appendfile.h"
#include "core/values/sampleblock.h"

#include <QTimeZone>

namespace gorizont {

/// The pair of binary files of one accelerometer: int16 little-endian in raw units, X and Y always of equal length. A
/// pair holds samplesPerFile samples without a gap and is named after the time of the first (manual 000, section 7;
/// spec/gorizont.md, section 4).
class SampleFile
{
public:
    SampleFile(const QString &folder, int number, qint64 samplesPerFile, const QTimeZone &zone);

    /// A block that does not follow the previous one begins a pair of its own. False: the rest of the block could not be
    /// written; the pair is closed, so that the next block begins a new one and the gap shows.
    bool append(const SampleBlock &block);

    void close();

    quint64 samplesSaved() const { return m_samplesSaved; } ///< since the start of the program
    QString error() const { return m_error; }

private:
    bool openPair(UtcTime start);
    bool createPair(const QString &pathX, const QString &pathY);
    bool write(const SampleBlock &block, qsizetype from, qsizetype count);

    QString m_folder;
    int m_number;
    qint64 m_samplesPerFile;
    QTimeZone m_zone;
    AppendFile m_x;
    AppendFile m_y;
    qint64 m_samplesInPair = 0;
    quint64 m_samplesSaved = 0;
    QString m_error;
};

} // namespace gorizont
