#pragma once

#include "core/files/recordfile.h"
#include "core/history/historyconfig.h"
#include "core/history/historyformat.h"
#include "core/history/logfile.h"
#include "core/history/samplefile.h"
#include "core/history/writehealth.h"

#include <QCoreApplication>

#include <functional>
#include <map>

namespace gorizont {

/// The files of one History folder: opens the right one, and says what the operator must know when one cannot be
/// written. Storage thread.
class HistoryFiles
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::HistoryFiles)

public:
    using Note = std::function<void(JournalKind, const QString &)>;

    /// Events that wait for the log file; beyond them the oldest are dropped.
    static constexpr qsizetype mostEvents = 10000;

    HistoryFiles(const HistoryConfig &config, Note note);

    /// Repairs what an unclean end left, and opens the data file, so that a folder that cannot be used is known before
    /// the first record is due.
    void open(QDate today);
    void close();

    void writeData(QDate today, const QByteArray &record);
    void writeAcceleration(QDate today, const QByteArray &record);
    void writeWeather(QDate today, const QByteArray &records);

    /// Returns the samples that are in the files of the block's sensor since the start of the program.
    quint64 save(const SampleBlock &block);

    void addEvents(const QList<JournalEntry> &events) { m_events += events; }
    /// Writes the events that wait, each into the month in which it happened; what cannot be written waits on.
    void writeEvents();

private:
    void write(HistoryStream stream, RecordFile &file, const QString &name, const QByteArray &record);
    void noteOutcome(HistoryStream stream, bool isWritten, const QString &error);
    void noteRepaired(const QString &name);
    QString pathOf(const QString &name) const { return m_folder + u'/' + name; }

    const QString m_folder;
    const QTimeZone m_zone;
    const Note m_note;
    RecordFile m_data;
    RecordFile m_acceleration;
    RecordFile m_weather;
    LogFile m_log;
    std::map<int, SampleFile> m_samples; ///< by N
    QList<JournalEntry> m_events;
    WriteHealth m_health;
};

} // namespace gorizont
