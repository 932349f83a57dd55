#include "core/archive/archiverecorder.h"

#include "core/archive/damagedfile.h"

#include <QDir>
#include <QFileInfo>

#include <cmath>

namespace gorizont {

namespace {

/// Axes that are turned make of the steps of a device, 1/256 of an arc-second or larger, numbers of 53 bits without a
/// pattern, five times as long. Thousandths are a quarter of a step, and short.
KeptReading roundedTilt(KeptReading reading)
{
    constexpr double parts = 1000;
    for (KeptValue &kept : reading.values) {
        const bool isTilt = kept.quantity == Quantity::TiltX || kept.quantity == Quantity::TiltY;
        if (isTilt && kept.value) {
            kept.value = std::round(*kept.value * parts) / parts;
        }
    }
    return reading;
}

} // namespace

ArchiveRecorder::ArchiveRecorder(const ArchiveConfig &config, Note note)
    : m_config(config)
    , m_note(std::move(note))
    , m_store(config)
    , m_ledger(config.lines)
{
    for (const LineConfig &line : config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            m_rules.insert(
                sensor.number,
                {quantitiesOf(sensor), {sensor.offsetX, sensor.offsetY, sensor.offsetT}, sensor.rotationX != 0});
        }
    }
}

bool ArchiveRecorder::lock()
{
    const QString path = m_config.driver == ArchiveDriver::Sqlite ? m_config.file : spoolFile(m_config);
    if (m_lock || path.isEmpty()) {
        return true;
    }
    QDir().mkpath(QFileInfo(path).absolutePath());
    auto lock = std::make_unique<QLockFile>(path + QStringLiteral(".lock"));
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0)) {
        const bool isHeld = lock->error() == QLockFile::LockFailedError;
        m_fault = isHeld ? ArchiveFault::Busy : ArchiveFault::Denied;
        const QString file = QDir::toNativeSeparators(path);
        m_error = isHeld ? tr("Another copy of the program writes into %1. Close it, or name another file.").arg(file)
                         : tr("%1 cannot be opened for writing. Check the rights and the name.").arg(file);
        return false;
    }
    m_lock = std::move(lock);
    return true;
}

bool ArchiveRecorder::open(UtcTime now)
{
    if (!lock()) {
        return false;
    }
    openSpool();
    if (openStore(now)) {
        return true;
    }
    bridge(now);
    return false;
}

bool ArchiveRecorder::openStore(UtcTime now)
{
    ArchiveDatabase &database = m_store.database();
    if (!database.open()) {
        return fail();
    }
    if (!database.begin() || !load(now) || !database.commit()) {
        fail();
        database.close();
        return false;
    }
    return true;
}

bool ArchiveRecorder::load(UtcTime now)
{
    const auto sensors = m_store.sensors();
    const auto rows = sensors ? m_store.tail() : std::nullopt;
    if (!rows) {
        return false;
    }
    const auto alive = m_store.aliveAt();
    if (!alive && m_store.database().fault() != ArchiveFault::None) {
        return false;
    }
    const auto applied = m_store.applied();
    if (!applied || !resumeSalvage(!alive)) {
        return false;
    }
    m_applied = *applied;
    m_known = *sensors;
    if (!m_isAnew) {
        replay(*rows);
        forgetWritten(alive);
        if (m_spool && !m_spool->isEmpty()) {
            bridge(now); // what is known is not in the tables yet
        }
    }
    return m_hasStarted || startLedger(now, alive.value_or(now));
}

/// What waits was committed, and only the answer was lost.
void ArchiveRecorder::forgetWritten(const std::optional<UtcTime> &alive)
{
    if (m_spool && isApplied(m_spool->next())) {
        m_spool->skip();
        m_waiting = {};
    } else if (m_triedAt && m_triedAt == alive) {
        m_waiting = {};
    }
}

/// Ends the gaps of the program before, which was there until \a alive. N → up to when something is known of it.
std::optional<QHash<int, UtcTime>> ArchiveRecorder::knownUntil(UtcTime alive)
{
    const auto ends = m_store.endOpenGaps(alive);
    if (!ends) {
        return {};
    }
    QHash<int, UtcTime> knownUntil = *ends;
    for (auto known = m_known.cbegin(); known != m_known.cend(); ++known) {
        knownUntil[known.key()] = std::max(knownUntil.value(known.key(), known->until), known->until);
    }
    for (const auto &[number, sensor] : m_open.sensors()) {
        if (sensor.validAt) {
            knownUntil[number] = std::max(knownUntil.value(number, *sensor.validAt), *sensor.validAt);
        }
    }
    return knownUntil;
}

bool ArchiveRecorder::startLedger(UtcTime now, UtcTime alive)
{
    const auto known = knownUntil(alive);
    if (known) {
        m_ledger.start(now, *known);
        m_hasStarted = true;
    }
    return known.has_value();
}

void ArchiveRecorder::replay(const QList<ArchiveStore::TailRow> &rows)
{
    m_open.clear();
    m_lastRow = 0;
    for (const ArchiveStore::TailRow &row : rows) {
        m_lastRow = row.id;
        const auto contents = TailBatch::decode(row.data);
        if (!contents) {
            m_note(JournalKind::Error, tr("A part of the archive of about a second is damaged and left out."));
            continue;
        }
        for (const KeptReading &reading : contents->readings) {
            if (row.id > m_known.value(reading.number).readingsDone) {
                m_open.add(reading, row.id);
            }
        }
        for (const SampleBlock &block : contents->blocks) {
            if (row.id > m_known.value(block.number).samplesDone) {
                m_open.add(block, row.id);
            }
        }
    }
}

void ArchiveRecorder::take(const ArchiveInbox::Contents &contents, UtcTime now)
{
    for (const ArchiveInbox::LineChange &change : contents.lines) {
        m_ledger.add(change.status, change.time);
    }
    for (auto dropped = contents.dropped.cbegin(); dropped != contents.dropped.cend(); ++dropped) {
        m_ledger.addLost(dropped.key(), *dropped);
    }
    for (auto dropped = contents.droppedBlocks.cbegin(); dropped != contents.droppedBlocks.cend(); ++dropped) {
        m_ledger.addLost(dropped.key(), *dropped);
    }
    for (const Reading &reading : contents.readings) {
        const auto rules = m_rules.constFind(reading.number);
        if (rules == m_rules.constEnd()) {
            continue;
        }
        m_ledger.add(reading);
        if (reading.isAnswer) {
            const KeptReading kept = keptReading(reading, rules->quantities);
            m_waiting.readings.append(rules->isTurned ? roundedTilt(kept) : kept);
        }
    }
    for (const SampleBlock &block : contents.blocks) {
        if (m_rules.contains(block.number) && !block.x.isEmpty() && !block.y.isEmpty() && block.rate > 0) {
            m_waiting.blocks.append(block);
        }
    }
    for (const Backfill &backfill : contents.backfills) {
        takeBackfill(backfill);
    }
    m_waiting.entries += contents.entries;
    m_ledger.tick(now);
    noteDropped(contents);
}

void ArchiveRecorder::noteDropped(const ArchiveInbox::Contents &contents)
{
    if (!contents.dropped.isEmpty() || contents.blocksDropped > 0 || contents.entriesDropped > 0) {
        m_note(
            JournalKind::Error,
            tr("The archive could not be written for too long: readings of %1 sensors, %2 blocks of samples and %3 "
               "events are not in it.")
                .arg(contents.dropped.size())
                .arg(contents.blocksDropped)
                .arg(contents.entriesDropped));
    }
    if (contents.backfillsDropped > 0) {
        m_note(
            JournalKind::Error,
            tr("The archive could not be written for too long: records that sensors had kept are not in it. Read them "
               "again."));
    }
}

bool ArchiveRecorder::commit(UtcTime now)
{
    m_waiting.gaps += m_ledger.takeChanges();
    const bool isBehind = m_spool && (!isOpen() || !m_spool->isEmpty());
    const bool isWritten = isBehind ? spoolWaiting(now) : writeWaiting(now);
    m_isWaiting = !isWritten && (isBehind || !m_spool || !spoolWaiting(now));
    return isOpen() && (isWritten || isBehind) && drain() && writeChunks(m_isAnew);
}

bool ArchiveRecorder::finish(ArchiveInbox &inbox, UtcTime now)
{
    if (m_isWaiting) {
        commit(now);
    }
    if (m_isWaiting) {
        return false;
    }
    take(inbox.take(), now);
    m_ledger.stop(now);
    const bool isWritten = (isOpen() || isBridging()) && commit(now);
    return isWritten || (isBridging() && !m_isWaiting);
}

void ArchiveRecorder::close()
{
    m_store.database().close();
    m_lock.reset();
}

bool ArchiveRecorder::writeWaiting(UtcTime now)
{
    m_waiting.time = now;
    m_triedAt = now;
    if (!writeBatches({m_waiting}, m_spool ? m_spool->next() : SpoolMark())) {
        return false;
    }
    m_triedAt.reset();
    if (m_spool) {
        m_spool->skip();
    }
    m_waiting = {};
    return true;
}

/// All in one transaction, and with them the mark of the last one.
bool ArchiveRecorder::writeBatches(const QList<ArchiveBatch> &batches, const SpoolMark &mark)
{
    ArchiveDatabase &database = m_store.database();
    const QHash<int, KnownSensor> knownBefore = m_known;
    m_backfills.setAdded(m_backfilled);
    QList<qint64> rows;
    bool isGood = database.begin();
    for (const ArchiveBatch &batch : batches) {
        rows.append(0);
        isGood = isGood && writeBatch(batch, &rows.last());
    }
    if (!isGood || (mark.spool != 0 && !m_store.setApplied(mark)) || !database.commit()) {
        fail();
        database.rollback();
        m_rollups.forget();
        m_known = knownBefore;
        return false;
    }
    m_applied = mark;
    m_backfilled = m_backfills.added();
    for (qsizetype i = 0; i < batches.size(); ++i) {
        m_lastRow = std::max(m_lastRow, rows.at(i));
        for (const KeptReading &reading : batches.at(i).readings) {
            m_open.add(reading, rows.at(i));
        }
        for (const SampleBlock &block : batches.at(i).blocks) {
            m_open.add(block, rows.at(i));
        }
    }
    return true;
}

bool ArchiveRecorder::writeBatch(const ArchiveBatch &waiting, qint64 *row)
{
    if (waiting.startedAt && !writeStop(*waiting.startedAt)) {
        return false;
    }
    TailBatch batch;
    for (const KeptReading &reading : waiting.readings) {
        batch.add(reading);
        if (!m_known.contains(reading.number)) {
            const KnownSensor sensor{reading.time, reading.time, 0, 0};
            if (!m_store.putSensor(reading.number, sensor)) {
                return false;
            }
            m_known.insert(reading.number, sensor);
        }
    }
    for (const SampleBlock &block : waiting.blocks) {
        batch.add(block);
    }
    if (!batch.isEmpty()) {
        const auto id = m_store.appendTail(batch.take());
        if (!id) {
            return false;
        }
        *row = *id;
    }
    for (const JournalEntry &entry : waiting.entries) {
        if (!m_store.appendEvent(entry)) {
            return false;
        }
    }
    for (const Gap &gap : waiting.gaps) {
        if (!m_gaps.lay(gap)) {
            return false;
        }
    }
    for (const Backfill &backfill : waiting.backfills) {
        if (!writeBackfill(backfill, waiting.time)) {
            return false;
        }
    }
    return m_store.setAlive(waiting.time);
}

bool ArchiveRecorder::fail()
{
    m_fault = m_store.database().fault();
    m_error = m_store.database().error();
    return false;
}

} // namespace gorizont
