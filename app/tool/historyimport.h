#pragma once

#include "core/archive/archiverecorder.h"
#include "core/history/historysource.h"
#include "core/history/monthfiles.h"
#include "core/history/monthrecords.h"

#include <QCoreApplication>

#include <functional>
#include <map>

namespace gorizont::tool {

/// What an import read and what was new of it.
struct ImportReport
{
    qint64 files = 0; ///< of text and pairs of samples that were read
    qint64 records = 0; ///< whole lines of text
    qint64 damaged = 0; ///< lines that are none
    qint64 foreign = 0; ///< files that were left out: their records hold another number of sensors
    qint64 added = 0; ///< readings and samples that the archive did not have
    QStringList complaints; ///< sentences
    QString failure; ///< why it ended early, a sentence; what was done until then stays
};

/// Brings the text and binary files of a History folder into an archive in which no program writes, where the archive
/// knows nothing of the sensor. Every hour is one transaction: it may be broken off and begun again. Any one thread.
class HistoryImport
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::tool::HistoryImport)

public:
    using Progress = std::function<void(const QString &file, int percent)>;

    HistoryImport(const HistoryFolder &folder, const ArchiveConfig &archive, Progress progress);

    ImportReport run(UtcTime now);

private:
    /// Both files of one month, which tell of some sensors together.
    struct Month
    {
        QString data; ///< path; empty: there is none, or it is foreign
        QString acceleration;
    };
    using Readings = std::map<int, std::map<UtcTime, Reading>>; ///< by N

    std::map<QString, Month> months();
    QString accepted(const QString &path, MonthFile kind);
    void survey(const QString &path, qsizetype groups);
    bool importMonth(const Month &month);
    static void takeHour(
        const std::optional<MonthRecords> &records, MonthFile kind, const QList<int> &columns, UtcTime from,
        Readings &readings);
    QList<Backfill> backfillsOf(
        const Readings &readings, const QString &source, std::chrono::microseconds period) const;
    bool importSamples();
    bool commit(const QList<Backfill> &backfills);

    const HistoryFolder m_folder;
    const Progress m_progress;
    ArchiveRecorder m_recorder;
    QHash<int, QList<Quantity>> m_quantities; ///< by N
    ImportReport m_report;
    UtcTime m_now;
};

} // namespace gorizont::tool
