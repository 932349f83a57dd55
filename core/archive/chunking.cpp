// The part of ArchiveRecorder that makes chunks and rollups of what is open.

#include "core/archive/archiverecorder.h"

namespace gorizont {

/// All that are ripe in one transaction: it costs one wait for the disk.
bool ArchiveRecorder::writeChunks(bool isEverything)
{
    QList<int> readings;
    QList<int> samples;
    for (const auto &[number, sensor] : m_open.sensors()) {
        if (!sensor.readings.isEmpty() && (isEverything || OpenChunks::isRipe(sensor.readings, m_lastRow))) {
            readings.append(number);
        }
        if (!sensor.samples.isEmpty() && (isEverything || OpenChunks::isRipe(sensor.samples, m_lastRow))) {
            samples.append(number);
        }
    }
    if (readings.isEmpty() && samples.isEmpty()) {
        m_isAnew = false;
        return true;
    }
    ArchiveDatabase &database = m_store.database();
    const OpenChunks before = m_open;
    const QHash<int, KnownSensor> knownBefore = m_known;
    bool isGood = database.begin();
    for (const int number : std::as_const(readings)) {
        isGood = isGood && writeReadings(number, before.sensors().at(number));
    }
    for (const int number : std::as_const(samples)) {
        isGood = isGood && writeSamples(number, before.sensors().at(number));
    }
    isGood = isGood && m_store.removeTailBelow(m_open.firstRow(m_lastRow + 1));
    if (isGood && m_isAnew && m_salvage) {
        isGood = m_store.setSalvageMark(m_salvage->mark());
    }
    if (isGood && database.commit()) {
        m_isAnew = false;
        noteRollups();
        return true;
    }
    fail();
    database.rollback();
    m_rollups.forget();
    m_open = before;
    m_known = knownBefore;
    return false;
}

void ArchiveRecorder::noteRollups()
{
    if (const int count = m_rollups.takeDamaged(); count > 0) {
        m_note(
            JournalKind::Error,
            tr("Rollups of the archive were damaged, %1 of them. They were made again from the readings that are still "
               "there.")
                .arg(count));
    }
}

bool ArchiveRecorder::writeReadings(int number, const OpenChunks::Sensor &sensor)
{
    const ValueOffsets offsets = m_rules.value(number).offsets;
    for (const ReadingChunk &chunk : sensor.readings.chunks) {
        const QByteArray data = encodeChunk(chunk, offsets);
        if (!m_store.appendChunk(ChunkKind::FullRate, number, spanOf(chunk), data)
            || !m_rollups.add(number, chunk, offsets)) {
            return false;
        }
    }
    KnownSensor &known = m_known[number];
    known.until = std::max(known.until, sensor.validAt.value_or(known.until));
    known.readingsDone = sensor.readings.lastRow;
    m_open.dropReadings(number);
    return m_store.putSensor(number, known);
}

bool ArchiveRecorder::writeSamples(int number, const OpenChunks::Sensor &sensor)
{
    for (const SampleChunk &chunk : sensor.samples.chunks) {
        if (!m_store.appendChunk(ChunkKind::Samples, number, spanOf(chunk), encodeChunk(chunk))
            || !m_rollups.add(number, chunk)) {
            return false;
        }
    }
    KnownSensor &known = m_known[number];
    if (known.from == UtcTime()) {
        known.from = sensor.samples.chunks.first().starts.front();
        known.until = known.from;
    }
    known.samplesDone = sensor.samples.lastRow;
    m_open.dropSamples(number);
    return m_store.putSensor(number, known);
}

} // namespace gorizont
