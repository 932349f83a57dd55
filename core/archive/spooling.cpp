// The half of ArchiveRecorder that bridges a server that is gone.

#include "core/archive/archiverecorder.h"

#include <QDir>
#include <QFileInfo>

namespace gorizont {

namespace {

constexpr qsizetype mostBatches = 100; ///< in a transaction
constexpr qint64 mostBytes = 4 << 20;

SteadyTime steadyNow()
{
    return std::chrono::steady_clock::now();
}

} // namespace

QString spoolFile(const ArchiveConfig &config)
{
    const QFileInfo file(config.file);
    return config.driver == ArchiveDriver::Sqlite || config.file.isEmpty()
        ? QString()
        : file.path() + u'/' + file.completeBaseName() + QStringLiteral(".spool");
}

void ArchiveRecorder::openSpool()
{
    const QString path = spoolFile(m_config);
    if (path.isEmpty()) {
        return;
    }
    if (!m_spool) {
        m_spool = std::make_unique<SpoolFile>(path, m_config.mostSpoolBytes);
    }
    if (!m_spool->isOpen()) {
        noteSpool(m_spool->open());
    }
}

/// The ledger begins without what the server knows; the time before is told when the server is back.
void ArchiveRecorder::bridge(UtcTime now)
{
    if (m_spool && m_spool->isOpen() && !m_hasStarted) {
        m_waiting.startedAt = now;
        m_ledger.start(now, {});
        m_hasStarted = true;
    }
}

/// Between the last commit of the program before and the start of this one.
bool ArchiveRecorder::writeStop(UtcTime startedAt)
{
    const auto alive = m_store.aliveAt();
    if (!alive) {
        return m_store.database().fault() == ArchiveFault::None; // there was none
    }
    const auto known = knownUntil(*alive);
    if (!known) {
        return false;
    }
    for (auto sensor = known->cbegin(); sensor != known->cend(); ++sensor) {
        if (m_rules.contains(sensor.key()) && *sensor < startedAt
            && !m_store.putGap({sensor.key(), *sensor, startedAt, GapReason::ProgramStopped, {}})) {
            return false;
        }
    }
    return true;
}

bool ArchiveRecorder::spoolWaiting(UtcTime now)
{
    m_waiting.time = now;
    const bool isGood = m_spool->append(m_waiting.encode());
    noteSpool(isGood);
    if (isGood) {
        m_waiting = {};
        m_triedAt.reset();
    }
    return isGood;
}

/// For a part of the time between two commits. False: the server failed.
bool ArchiveRecorder::drain()
{
    const SteadyTime until = steadyNow() + m_config.commitInterval / 4;
    while (m_spool && !m_spool->isEmpty() && steadyNow() < until) {
        if (!drainSome()) {
            return false;
        }
    }
    return true;
}

bool ArchiveRecorder::drainSome()
{
    const Spooled some = readSpool();
    if (!some.batches.isEmpty() && !writeBatches(some.batches, some.mark)) {
        return false;
    }
    if (some.hasDamage) {
        m_note(
            JournalKind::Error,
            tr("%1 is damaged: a part of what was measured while the server of the archive was gone is left out.")
                .arg(QDir::toNativeSeparators(m_spool->path())));
    }
    m_spool->drop(some.end);
    if (some.isUnreadable) {
        m_fault = ArchiveFault::Other;
        m_error = tr("%1 cannot be read. Check that disk.").arg(m_spool->error());
    }
    return !some.isUnreadable;
}

/// A batch that begins a program is the first of a transaction: what came before it is known then.
ArchiveRecorder::Spooled ArchiveRecorder::readSpool()
{
    Spooled some{{}, m_applied, m_spool->from(), false, false};
    while (some.batches.size() < mostBatches && some.end - m_spool->from() < mostBytes) {
        const auto entry = m_spool->read(some.end);
        if (!entry && m_spool->isUnreadable()) {
            some.isUnreadable = true;
            break;
        }
        if (!entry) {
            some.hasDamage = some.hasDamage || some.end < m_spool->size();
            some.end = m_spool->size();
            break;
        }
        const auto batch = isApplied(entry->mark) ? std::nullopt : ArchiveBatch::decode(entry->batch);
        if (batch && batch->startedAt && !some.batches.isEmpty()) {
            break;
        }
        some.hasDamage = some.hasDamage || entry->hasDamageBefore || (!batch && !isApplied(entry->mark));
        if (batch) {
            some.batches.append(*batch);
            some.mark = entry->mark;
        }
        some.end = entry->end;
    }
    return some;
}

bool ArchiveRecorder::isApplied(const SpoolMark &mark) const
{
    return mark.spool == m_applied.spool && mark.sequence <= m_applied.sequence;
}

/// One event when the first thing goes wrong, none while it stays so.
void ArchiveRecorder::noteSpool(bool isGood)
{
    if (!isGood && !m_isSpoolFailing) {
        m_note(
            JournalKind::Error,
            tr("What is measured while the server of the archive is gone cannot be kept: %1. Free some room there.")
                .arg(m_spool->error()));
    }
    m_isSpoolFailing = !isGood;
}

} // namespace gorizont
