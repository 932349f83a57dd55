// The part of ArchiveRecorder that goes on after damage.

#include "core/archive/archiverecorder.h"
#include "core/archive/damagedfile.h"

namespace gorizont {

void ArchiveRecorder::startAnew()
{
    m_store.database().close();
    m_rollups.forget();
    m_known.clear();
    m_open.forgetRows();
    m_lastRow = 0;
    m_isAnew = true;
}

void ArchiveRecorder::startSalvage(const QString &file)
{
    m_salvage = std::make_unique<Salvage>(file, m_config, SalvageMark{copyName(file), 0, 0, 0, !m_hasStarted});
}

/// What an earlier run did not come to the end of. A store that is new takes over the last copy: that run came no
/// further than to set it aside.
bool ArchiveRecorder::resumeSalvage(bool isNew)
{
    if (m_config.driver != ArchiveDriver::Sqlite) {
        return true;
    }
    if (!m_salvage) {
        const auto mark = m_store.salvageMark();
        if (!mark) {
            return false;
        }
        for (const QString &copy : copiesOf(m_config.file)) {
            const bool isWanted = isNew ? !m_salvage : copyName(copy) == mark->copy;
            if (isWanted) {
                const SalvageMark from = isNew ? SalvageMark{copyName(copy), 0, 0, 0, true} : *mark;
                m_salvage = std::make_unique<Salvage>(copy, m_config, from);
            }
        }
    }
    return !m_salvage || putSalvageMark();
}

bool ArchiveRecorder::putSalvageMark()
{
    SalvageMark mark = m_salvage->mark();
    mark.takesTail = mark.takesTail || m_isAnew; // until what was open is written, only the tail has it
    return m_store.setSalvageMark(mark);
}

/// False: the store failed; the same rows are tried again.
bool ArchiveRecorder::salvage()
{
    if (!m_salvage) {
        return true;
    }
    ArchiveDatabase &database = m_store.database();
    const QHash<int, KnownSensor> knownBefore = m_known;
    auto outcome = database.begin() ? m_salvage->step(m_store, m_rollups) : Salvage::Outcome::Failed;
    const bool isDone = outcome == Salvage::Outcome::Done;
    const bool isGood = outcome != Salvage::Outcome::Failed && putSalvagedSensors()
        && (isDone ? m_store.setSalvageMark({}) : putSalvageMark()) && database.commit();
    if (!isGood) {
        fail();
        database.rollback();
        m_rollups.forget();
        m_salvage->undo();
        m_known = knownBefore;
        return false;
    }
    if (isDone) {
        m_note(
            JournalKind::Info,
            tr("What could be read of the damaged archive is in the new one: %1 rows.").arg(m_salvage->mark().rescued));
        m_salvage.reset();
    }
    return true;
}

bool ArchiveRecorder::putSalvagedSensors()
{
    const QHash<int, UtcTime> from = m_salvage->knownFrom();
    for (auto sensor = from.cbegin(); sensor != from.cend(); ++sensor) {
        const auto known = m_known.constFind(sensor.key());
        if (known != m_known.constEnd() && known->from <= *sensor) {
            continue;
        }
        KnownSensor &earlier = m_known[sensor.key()];
        earlier.from = *sensor;
        earlier.until = std::max(earlier.until, *sensor);
        if (!m_store.putSensor(sensor.key(), earlier)) {
            return false;
        }
    }
    return true;
}

} // namespace gorizont
