#pragma once

#include "core/archive/archivedatabase.h"
#include "core/archive/chunkkind.h"
#include "core/archive/spoolfile.h"
#include "core/values/devicerecord.h"
#include "core/values/gap.h"
#include "core/values/journalentry.h"

#include <QHash>

#include <optional>

namespace gorizont {

/// What the tables say of one sensor.
struct KnownSensor
{
    UtcTime from; ///< of the first reading
    UtcTime until; ///< of the last one in a chunk
    qint64 readingsDone = 0; ///< the last row of tail whose readings are in chunks
    qint64 samplesDone = 0; ///< likewise its samples
};

/// How far what was set aside is taken over.
struct SalvageMark
{
    qint64 copy = 0; ///< which file, see copyName(); 0: none
    int table = 0; ///< of Salvage
    qint64 last = 0; ///< the row there
    qint64 rescued = 0; ///< rows
    bool takesTail = true; ///< what is in no chunk is wanted too
    bool operator==(const SalvageMark &) const = default;
};

/// The rows of the archive: one method a statement. False and empty answers: see fault(). Archive thread.
class ArchiveStore
{
public:
    explicit ArchiveStore(const ArchiveConfig &config)
        : m_database(config, ArchiveDatabase::Access::Write)
    {
    }

    ArchiveDatabase &database() { return m_database; }

    std::optional<UtcTime> aliveAt(); ///< when the last commit was; empty: never
    bool setAlive(UtcTime now);

    std::optional<SpoolMark> applied(); ///< the last batch that came with a mark; its spool is 0: none did
    bool setApplied(const SpoolMark &mark);

    std::optional<SalvageMark> salvageMark();
    bool setSalvageMark(const SalvageMark &mark);

    struct TailRow
    {
        qint64 id = 0;
        QByteArray data;
    };
    std::optional<QList<TailRow>> tail(); ///< empty: not all of it could be read
    std::optional<qint64> appendTail(const QByteArray &data); ///< its id
    bool removeTailBelow(qint64 id);

    std::optional<QHash<int, KnownSensor>> sensors();
    bool putSensor(int number, const KnownSensor &sensor);

    bool appendChunk(ChunkKind kind, int number, const TimeSpan &span, const QByteArray &data);
    std::optional<QByteArray> rollup(ChunkKind kind, const SeriesKey &key, UtcTime stretch); ///< empty: there is none
    bool putRollup(ChunkKind kind, const SeriesKey &key, UtcTime stretch, const QByteArray &data);

    /// The data of rows that touch \a span, in the order of their time. Empty: not all could be read.
    std::optional<QList<QByteArray>> rollups(ChunkKind kind, const SeriesKey &key, const TimeSpan &span);
    std::optional<QList<QByteArray>> chunks(ChunkKind kind, int number, const TimeSpan &span);

    /// One gap of a sensor begins at one time: the same again changes it.
    bool putGap(const Gap &gap);
    bool removeGap(int number, UtcTime start);
    /// Those that \a span touches, in ascending time.
    std::optional<QList<Gap>> gaps(int number, const TimeSpan &span);
    /// Those that begin in \a span, in ascending time.
    std::optional<QList<Gap>> gapsBeginning(int number, const TimeSpan &span);
    /// The first of all gaps of a sensor; empty: there is none, or fault().
    std::optional<UtcTime> firstGap(int number);
    /// Those that still went on did so until \a at. Returns the last end known of each sensor.
    std::optional<QHash<int, UtcTime>> endOpenGaps(UtcTime at);
    bool appendEvent(const JournalEntry &entry);
    /// A record that is there already stays as it is.
    bool putRecord(const DeviceRecord &record, bool *isNew);
    /// Different ones, ascending.
    std::optional<std::vector<UtcTime>> recordTimes(int number, const TimeSpan &span);
    /// Where the chunks of \a kind are that begin in \a span; ascending.
    std::optional<QList<TimeSpan>> chunkSpans(ChunkKind kind, int number, const TimeSpan &span);

private:
    std::optional<QList<Gap>> gapsWhere(int number, const QString &condition, const QVariantList &values);
    std::optional<QList<QByteArray>> dataOf(const QString &rows, const QVariantList &values);

    ArchiveDatabase m_database;
};

qint64 storedTime(UtcTime time);
UtcTime readTime(const QVariant &value);

} // namespace gorizont
