#include "core/archive/recordkeeper.h"

#include "core/archive/gapmath.h"

#include <QMutexLocker>

#include <numeric>
#include <utility>

namespace gorizont {

namespace {

qsizetype countOf(const QList<DeviceRecords> &batches)
{
    return std::accumulate(batches.begin(), batches.end(), qsizetype(0), [](qsizetype sum, const auto &batch) {
        return sum + batch.records.size();
    });
}

/// A gap that goes on is followed by somebody else, who would write it again.
bool fillGaps(ArchiveStore &store, int number, const TimeSpan &span, const QString &source)
{
    QSqlQuery *rows = store.database().run(
        QStringLiteral(
            "SELECT start, finish, reason FROM gap WHERE number = ? AND source = '' AND finish > ? AND start < ?"),
        {number, storedTime(span.from), storedTime(span.to)});
    if (!rows) {
        return false;
    }
    QList<Gap> gaps;
    while (rows->next()) {
        gaps.append(
            {number,
             readTime(rows->value(0)),
             readTime(rows->value(1)),
             static_cast<GapReason>(rows->value(2).toInt()),
             {}});
    }
    for (const Gap &gap : filled(gaps, span, source)) {
        if (!store.putGap(gap)) {
            return false;
        }
    }
    return true;
}

bool writeBatch(ArchiveStore &store, const DeviceRecords &batch)
{
    for (const DeviceRecord &record : batch.records) {
        bool isNew = false;
        if (!store.putRecord(record, &isNew)) {
            return false;
        }
    }
    for (const TimeSpan &span : batch.filled) {
        if (!fillGaps(store, batch.number, span, batch.source)) {
            return false;
        }
    }
    return true;
}

} // namespace

void RecordKeeper::put(const DeviceRecords &records)
{
    const QMutexLocker lock(&m_mutex);
    if (countOf(m_waiting) + records.records.size() <= mostRecords) {
        m_waiting.append(records);
    }
}

QList<DeviceRecords> RecordKeeper::take()
{
    const QMutexLocker lock(&m_mutex);
    return std::exchange(m_waiting, {});
}

void RecordKeeper::putBack(const QList<DeviceRecords> &taken)
{
    const QMutexLocker lock(&m_mutex);
    m_waiting = taken + m_waiting;
}

qsizetype RecordKeeper::waiting() const
{
    const QMutexLocker lock(&m_mutex);
    return countOf(m_waiting);
}

bool RecordKeeper::write(ArchiveStore &store)
{
    ArchiveDatabase &database = store.database();
    if (!database.isOpen()) {
        return false;
    }
    const QList<DeviceRecords> taken = take();
    if (taken.isEmpty()) {
        return true;
    }
    bool isGood = database.begin();
    for (const DeviceRecords &batch : taken) {
        isGood = isGood && writeBatch(store, batch);
    }
    if (isGood && database.commit()) {
        return true;
    }
    database.rollback();
    putBack(taken);
    return false;
}

} // namespace gorizont
