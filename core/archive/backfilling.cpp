// The part of ArchiveRecorder that takes in what was measured long ago.

#include "core/archive/archiverecorder.h"

namespace gorizont {

namespace {

constexpr qsizetype mostCharacters = 64; ///< of a source and of the name of a record: the tables hold no more

} // namespace

void ArchiveRecorder::takeBackfill(Backfill backfill)
{
    const auto rules = m_rules.constFind(backfill.number);
    if (rules == m_rules.constEnd()) {
        return;
    }
    backfill.source.truncate(mostCharacters);
    for (DeviceRecord &record : backfill.records) {
        record.number = backfill.number;
        record.name.truncate(mostCharacters);
    }
    for (KeptReading &reading : backfill.readings) {
        reading.number = backfill.number;
        reading.values.removeIf([&rules](const KeptValue &kept) { return !rules->quantities.contains(kept.quantity); });
    }
    m_waiting.backfills.append(backfill);
}

bool ArchiveRecorder::writeBackfill(const Backfill &backfill, UtcTime now)
{
    BackfillBook::Sensor sensor;
    if (const auto known = m_known.constFind(backfill.number); known != m_known.constEnd()) {
        sensor.known = *known;
    }
    sensor.offsets = m_rules.value(backfill.number).offsets;
    if (const auto open = m_open.sensors().find(backfill.number); open != m_open.sensors().end()) {
        for (const SampleChunk &chunk : open->second.samples.chunks) {
            sensor.openSamples.append(spanOf(chunk));
        }
    }
    if (!m_backfills.add(backfill, sensor, now)) {
        return false;
    }
    if (sensor.known) {
        m_known.insert(backfill.number, *sensor.known);
    }
    return true;
}

} // namespace gorizont
