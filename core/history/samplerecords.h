#pragma once

#include "core/history/historyparser.h"
#include "core/values/sampleblock.h"
#include "core/values/series.h"

#include <QTimeZone>

#include <functional>

namespace gorizont {

/// The folder of binary files, `16_03_29_22_46_09_1X.wrd` (spec/gorizont.md, section 4): int16 in 1/8 arc-second, ten a
/// second, each file without a gap. Any one thread.
class SampleRecords
{
public:
    static constexpr std::chrono::microseconds period{100'000};

    /// \a gravity in m/s².
    SampleRecords(const QString &folder, const QTimeZone &zone, double gravity);

    std::optional<TimeSpan> span() const;

    /// Every sample of from ≤ t < to in mm/s², in order, until \a take returns false. \a key is SampleX or SampleY.
    using Take = std::function<bool(UtcTime, double)>;
    void read(const SeriesKey &key, UtcTime from, UtcTime to, const Take &take) const;

    /// What both axes of a pair of files hold, as the device said it, in pieces of less than an hour: those of one file
    /// one after the other, the files in ascending time; until \a take returns false.
    using TakeBlock = std::function<bool(const SampleBlock &)>;
    void readBlocks(const TakeBlock &take) const;

private:
    struct File
    {
        QString path;
        UtcTime start;
        qint64 samples = 0;
        int number = 0;
        char axis = 'X';
        UtcTime end() const { return start + samples * period; }
    };
    bool readPair(const File &x, const File &y, const TakeBlock &take) const;
    static bool readFile(const File &file, double scale, UtcTime from, UtcTime to, const Take &take);

    QList<File> m_files; ///< in ascending time
    double m_scale; ///< mm/s² of one raw unit
};

} // namespace gorizont
