#pragma once

#include "core/archive/archiverecorder.h"
#include "core/archive/retention.h"
#include "core/values/clockwatch.h"

#include <QObject>
#include <QTimer>

namespace gorizont {

/// Keeps every reading, sample and event in the archive. Lives on the archive thread: start() and stop() run there. The
/// slots above start() may be called from any thread, and should be connected with Qt::DirectConnection: they only leave
/// the value in an inbox of bounded size.
class ArchiveWriter : public QObject
{
    Q_OBJECT

public:
    using Clock = std::function<UtcTime()>;

    explicit ArchiveWriter(const ArchiveConfig &config, Clock clock = utcNow, QObject *parent = nullptr);
    ~ArchiveWriter() override;

    /// Readings that wait for the store; for any thread.
    std::size_t backlog() const { return m_inbox.waitingReadings(); }

public Q_SLOTS:
    void updateReadings(const QList<gorizont::Reading> &batch);
    void updateLine(const gorizont::LineStatus &status);
    void appendBlock(const gorizont::SampleBlock &block);
    void appendJournal(const gorizont::JournalEntry &entry);
    /// Each record goes in once, by its time and name, and the gaps that they cover are marked as filled from their source
    /// (filledParts() in gapmath.h says which). Where the archive knows nothing of the sensor the curves show the readings,
    /// and then they decide what is filled. The same again changes nothing.
    void appendRecords(const gorizont::DeviceRecords &records);

    /// Opens the store, and commits every commitInterval.
    void start();
    /// Writes what waits in the inbox.
    void flush();
    /// Writes what waits in the inbox and closes the store.
    void stop();

Q_SIGNALS:
    /// What the operator should know of the archive; comes back through appendJournal() like every other event.
    void journal(const gorizont::JournalEntry &entry);
    /// The file is another one from now on: who reads it opens it again.
    void replaced();

private:
    void takeInbox(UtcTime now, SteadyTime steady);
    void salvage();
    void sweep(UtcTime now);
    void makeRoom(UtcTime now);
    void finish();
    void failed();
    void succeeded();
    void note(JournalKind kind, const QString &text);

    const ArchiveConfig m_config;
    const Clock m_clock;
    ArchiveInbox m_inbox; ///< with m_records all that other threads touch
    ArchiveRecorder m_recorder;
    Retention m_retention;
    SteadyTime m_sweepAt; ///< the next time
    bool m_hasSweepFailed = false;
    QTimer m_timer{this};
    std::optional<SteadyTime> m_retryAt; ///< while something fails
    ClockWatch m_clockWatch;
};

} // namespace gorizont
