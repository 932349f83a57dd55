#pragma once

#include "core/history/cadence.h"
#include "core/history/capturefolder.h"
#include "core/history/historyconfig.h"
#include "core/history/historyfiles.h"
#include "core/history/historyinbox.h"
#include "core/values/clockwatch.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace gorizont {

/// Writes what the sensors say into the text and binary files (manual 000, sections 6 and 7). Lives in the storage
/// thread. The five slots that take values may be called from any thread, and should be connected with
/// Qt::DirectConnection: they only leave the value in an inbox of bounded size. If the disk hangs, readings and states
/// replace each other there, of every sensor SrsBufSize packets wait, older ones are dropped and the gap is recorded.
class HistoryWriter : public QObject
{
    Q_OBJECT

public:
    using Clock = std::function<UtcTime()>;

    explicit HistoryWriter(const HistoryConfig &config, Clock clock = utcNow, QObject *parent = nullptr);

    /// What waits for the disk; for any thread.
    HistoryInbox::Backlog backlog() const { return m_inbox.backlog(); }

public Q_SLOTS:
    void updateReadings(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);
    void appendBlock(const gorizont::SampleBlock &block);
    void appendJournal(const gorizont::JournalEntry &entry);
    void appendCapture(const gorizont::SignalCapture &captured);

    /// Repairs what an unclean end left, then writes a record every saveInterval, the first after the first interval.
    void start();
    /// Writes what waits in the inbox.
    void flush();
    /// Writes what waits in the inbox and closes every file.
    void stop();

Q_SIGNALS:
    /// Packets of 32 samples of sensor \a number that are in its files since the start of the program.
    void packetsSaved(int number, quint64 packets);
    /// The record of `_data` that was due, without its line end, whether or not it could be written.
    void dataLineWritten(const QString &line);
    /// What the operator should know of the files; comes back through appendJournal() like every other event.
    void journal(const gorizont::JournalEntry &entry);

private:
    void tick();
    void armTick();
    void writeRecords();
    void noteClockStep(SteadyTime now);
    void sweepCaptures(SteadyTime now);
    void noteDropped(const HistoryInbox::Contents &contents);
    void note(JournalKind kind, const QString &text);
    QDateTime wallTime() const { return localTime(m_clock(), m_config.zone); }

    const HistoryConfig m_config;
    const Clock m_clock;
    HistoryInbox m_inbox; ///< the only member that other threads touch
    HistoryFiles m_files;
    CaptureFolder m_captures;
    SteadyTime m_sweepAt; ///< when old captures are looked for
    QList<SensorColumns> m_sensors; ///< ascending N
    QHash<int, qsizetype> m_indexOfNumber;
    QList<LineStatus> m_lines;
    bool m_hasAccelerometers = false;
    bool m_hasVibration = false;
    bool m_hasWeatherStations = false;

    Cadence m_cadence;
    ClockWatch m_clockWatch;
    SteadyTime m_due;
    QTimer m_tickTimer{this};
    QTimer m_retryTimer{this};
};

} // namespace gorizont
