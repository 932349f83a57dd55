#pragma once

#include "core/archive/backfill.h"
#include "core/archive/gapbook.h"
#include "core/archive/openchunks.h"
#include "core/archive/rollupbook.h"

namespace gorizont {

/// Puts what was measured long ago among what is there: readings only where nothing is known of the sensor, so that the
/// same again adds nothing, and marks what they fill. Within a transaction; false: the store failed. Archive thread.
class BackfillBook
{
public:
    BackfillBook(ArchiveStore &store, RollupBook &rollups)
        : m_store(store)
        , m_rollups(rollups)
        , m_gaps(store)
    {
    }

    /// What the archive knows of the sensor beside its tables.
    struct Sensor
    {
        std::optional<KnownSensor> known;
        ValueOffsets offsets;
        QList<TimeSpan> openSamples; ///< what is in no chunk yet
        std::optional<UtcTime> widenedTo; ///< from here on it is known only now
    };

    /// \a sensor is changed where more is known then. What is later than \a now is left out: a clock was wrong.
    bool add(const Backfill &backfill, Sensor &sensor, UtcTime now);

    qint64 added() const { return m_added; } ///< readings and samples
    void setAdded(qint64 count) { m_added = count; } ///< what came since was not committed

private:
    bool addRecords(const Backfill &backfill, UtcTime now);
    bool addReadings(const Backfill &backfill, Sensor &sensor, UtcTime now);
    bool addBlocks(const Backfill &backfill, Sensor &sensor);
    bool widen(int number, Sensor &sensor, UtcTime from, UtcTime now);
    bool write(int number, const QList<KeptReading> &readings, Sensor &sensor);

    ArchiveStore &m_store;
    RollupBook &m_rollups;
    GapBook m_gaps;
    qint64 m_added = 0;
};

} // namespace gorizont
