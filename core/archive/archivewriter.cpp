#include "core/archive/archivewriter.h"

#include "core/archive/damagedfile.h"

#include <QDir>

namespace gorizont {

namespace {

SteadyTime steadyNow()
{
    return std::chrono::steady_clock::now();
}

} // namespace

ArchiveWriter::ArchiveWriter(const ArchiveConfig &config, Clock clock, QObject *parent)
    : QObject(parent)
    , m_config(config)
    , m_clock(std::move(clock))
    , m_recorder(config, [this](JournalKind kind, const QString &text) { note(kind, text); })
    , m_retention(config.retention)
    , m_sweepAt(steadyNow())
{
    m_timer.setInterval(config.commitInterval);
    connect(&m_timer, &QTimer::timeout, this, &ArchiveWriter::flush);
}

ArchiveWriter::~ArchiveWriter() = default;

void ArchiveWriter::updateReadings(const QList<Reading> &batch)
{
    m_inbox.put(batch);
}

void ArchiveWriter::updateLine(const LineStatus &status)
{
    m_inbox.put(status, m_clock());
}

void ArchiveWriter::appendBlock(const SampleBlock &block)
{
    m_inbox.put(block);
}

void ArchiveWriter::appendJournal(const JournalEntry &entry)
{
    m_inbox.put(entry);
}

void ArchiveWriter::appendRecords(const DeviceRecords &records)
{
    Backfill backfill{records.number, records.source, {}, records.records, {}, {}};
    for (const Reading &reading : records.readings) {
        backfill.readings.append(keptReading(reading, readingQuantities()));
    }
    m_inbox.put(backfill);
}

void ArchiveWriter::start()
{
    flush();
    m_timer.start();
}

void ArchiveWriter::flush()
{
    const UtcTime now = m_clock();
    const SteadyTime steady = steadyNow(); // of the same moment: what follows may wait for a server or a disk
    if (m_recorder.isBridging()) { // first of all: to ask a server that is gone takes a while
        takeInbox(now, steady);
        m_recorder.commit(now);
    }
    if (m_retryAt && steadyNow() < *m_retryAt) {
        return;
    }
    if (!m_recorder.isOpen() && !m_recorder.open(now)) {
        failed();
        return;
    }
    takeInbox(now, steady);
    if (m_recorder.commit(now)) {
        succeeded();
        salvage();
        sweep(now);
    } else {
        failed();
        makeRoom(now);
    }
}

void ArchiveWriter::takeInbox(UtcTime now, SteadyTime steady)
{
    if (m_recorder.canTake()) {
        if (const auto step = m_clockWatch.step(now, steady)) {
            m_recorder.clockStepped(now - *step, now);
        }
        m_recorder.take(m_inbox.take(), now);
    }
}

/// For a part of the time between two commits.
void ArchiveWriter::salvage()
{
    const SteadyTime until = steadyNow() + m_config.commitInterval / 4;
    while (m_recorder.hasSalvage() && steadyNow() < until) {
        if (!m_recorder.salvage()) {
            failed();
            return;
        }
    }
}

/// What could not be removed now is removed the next time. One event when that begins, and when it ends.
void ArchiveWriter::sweep(UtcTime now)
{
    if (!m_recorder.isOpen() || steadyNow() < m_sweepAt) { // the salvage before may have closed it
        return;
    }
    const auto outcome = m_retention.sweep(m_recorder.store(), now);
    const bool hasMore = outcome == Retention::Outcome::MoreToDo;
    const bool hasFailed = outcome == Retention::Outcome::Failed;
    m_sweepAt = steadyNow() + (hasMore ? m_config.commitInterval : m_config.retentionInterval);
    if (hasFailed && !m_hasSweepFailed) {
        note(
            JournalKind::Error,
            tr("What is too old cannot be removed from the archive: %1 It is tried again every few minutes.")
                .arg(m_recorder.store().database().error()));
    } else if (!hasFailed && m_hasSweepFailed) {
        note(JournalKind::Info, tr("What is too old is removed from the archive again."));
    }
    m_hasSweepFailed = hasFailed;
}

/// On a full disk what is too old makes room for what is new; there may still be some in the log for that.
void ArchiveWriter::makeRoom(UtcTime now)
{
    if (m_recorder.isOpen() && m_recorder.fault() == ArchiveFault::Full) {
        const auto outcome = m_retention.sweep(m_recorder.store(), now, Retention::Room::Kept);
        if (outcome == Retention::Outcome::Failed && m_config.driver == ArchiveDriver::Sqlite) {
            m_recorder.store().database().execute(QStringLiteral("PRAGMA wal_checkpoint")); // the log begins anew then
        }
    }
}

void ArchiveWriter::stop()
{
    m_timer.stop();
    finish();
    if (m_recorder.isAnew()) { // it was set aside just now: what is at hand goes into the next one
        finish();
    }
    m_recorder.close();
}

void ArchiveWriter::finish()
{
    const UtcTime now = m_clock();
    if (!m_recorder.isOpen() && !m_recorder.isBridging() && !m_recorder.open(now)) {
        failed();
    }
    if ((m_recorder.isOpen() || m_recorder.isBridging()) && !m_recorder.finish(m_inbox, now)) {
        failed();
    }
}

/// One event when the first thing goes wrong, none while it stays so.
void ArchiveWriter::failed()
{
    if (m_recorder.fault() == ArchiveFault::Damaged && m_config.driver == ArchiveDriver::Sqlite) {
        m_recorder.startAnew();
        const auto aside = setAside(m_config.file, m_clock());
        if (aside) {
            note(
                JournalKind::Error,
                tr("The archive %1 is damaged. It was set aside as %2, and recording goes on in a new file.")
                    .arg(QDir::toNativeSeparators(m_config.file), QDir::toNativeSeparators(*aside)));
            m_recorder.startSalvage(*aside);
            m_retryAt.reset();
            Q_EMIT replaced();
            return;
        }
    }
    if (!m_retryAt) {
        note(
            JournalKind::Error,
            m_recorder.hasSpool()
                ? tr("The archive is not being written: %1 Until it is, what is measured waits in %2.")
                      .arg(m_recorder.error(), QDir::toNativeSeparators(spoolFile(m_config)))
                : tr("The archive is not being written: %1 It is tried again every few seconds.")
                      .arg(m_recorder.error()));
    }
    m_retryAt = steadyNow() + m_config.retryInterval;
    if (m_recorder.fault() != ArchiveFault::Busy && m_recorder.fault() != ArchiveFault::Full) {
        m_recorder.store().database().close();
    }
}

void ArchiveWriter::succeeded()
{
    if (m_retryAt) {
        m_retryAt.reset();
        note(JournalKind::Info, tr("The archive is being written again."));
    }
}

void ArchiveWriter::note(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, m_clock(), text});
}

} // namespace gorizont
