#pragma once

#include "core/archive/archiveinbox.h"
#include "core/archive/archivestore.h"
#include "core/archive/backfillbook.h"
#include "core/archive/gapledger.h"
#include "core/archive/openchunks.h"
#include "core/archive/rollupbook.h"
#include "core/archive/salvage.h"
#include "core/archive/spoolbatch.h"
#include "core/archive/spoolfile.h"
#include "core/archive/tailbatch.h"

#include <QLockFile>

#include <functional>
#include <memory>

namespace gorizont {

/// Writes what the inbox held into the store. First into the tail, so that a kill loses nothing that was committed; when
/// enough is there, into chunks and rollups. What could not be written is tried again and is in no other place; only for
/// a server it waits in a spool beside. Archive thread.
class ArchiveRecorder
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::ArchiveRecorder)

public:
    using Note = std::function<void(JournalKind, const QString &)>;

    ArchiveRecorder(const ArchiveConfig &config, Note note);

    /// Opens the store and reads the tail. The first time the gap since the last commit begins to be told. False: see
    /// fault() and error().
    bool open(UtcTime now);
    bool isOpen() { return m_store.database().isOpen(); }
    /// The server is gone: what is taken goes into the spool.
    bool isBridging() { return m_spool && m_hasStarted && !isOpen(); }

    bool hasSpool() const { return m_spool && m_spool->isOpen(); }

    /// True: nothing waits to be written, take() is due.
    bool canTake() const { return m_hasStarted && !m_isWaiting; }
    void take(const ArchiveInbox::Contents &contents, UtcTime now);
    void clockStepped(UtcTime before, UtcTime after) { m_ledger.clockStepped(before, after); }

    /// Writes what was taken, what the spool holds, and chunks that are ripe. False: nothing of it was written, or not
    /// all chunks; it waits.
    bool commit(UtcTime now);
    /// The program ends: takes the last and commits it. What is in no chunk stays in the tail, so that it is quick.
    bool finish(ArchiveInbox &inbox, UtcTime now);
    void close();

    /// A damaged store is to be set aside: what is open goes into chunks of the next one.
    void startAnew();
    /// What was set aside as \a file is read from now on, a few rows with each call of salvage().
    void startSalvage(const QString &file);
    bool salvage();
    bool hasSalvage() const { return m_salvage != nullptr; }
    /// startAnew() was called, and what was open then is in no store yet.
    bool isAnew() const { return m_isAnew; }

    /// Readings and samples of backfills that were new.
    qint64 backfilled() const { return m_backfilled; }

    ArchiveStore &store() { return m_store; }
    ArchiveFault fault() const { return m_fault; }
    QString error() const { return m_error; } ///< one sentence

private:
    struct SensorRules
    {
        QList<Quantity> quantities;
        ValueOffsets offsets;
        bool isTurned = false; ///< RotX: the tilt is on no grid of the device
    };
    /// What the spool held up to some place.
    struct Spooled
    {
        QList<ArchiveBatch> batches; ///< those that the server does not have
        SpoolMark mark; ///< of the last one
        qint64 end = 0; ///< in the spool
        bool hasDamage = false;
        bool isUnreadable = false; ///< behind end
    };

    bool lock();
    void openSpool();
    bool openStore(UtcTime now);
    bool load(UtcTime now);
    std::optional<QHash<int, UtcTime>> knownUntil(UtcTime alive);
    bool startLedger(UtcTime now, UtcTime alive);
    void bridge(UtcTime now);
    void forgetWritten(const std::optional<UtcTime> &alive);
    void replay(const QList<ArchiveStore::TailRow> &rows);
    bool resumeSalvage(bool isNew);
    bool putSalvageMark();
    bool putSalvagedSensors();
    void takeBackfill(Backfill backfill);
    bool writeBackfill(const Backfill &backfill, UtcTime now);
    bool writeWaiting(UtcTime now);
    bool writeBatches(const QList<ArchiveBatch> &batches, const SpoolMark &mark);
    bool writeBatch(const ArchiveBatch &waiting, qint64 *row);
    bool writeStop(UtcTime startedAt);
    bool spoolWaiting(UtcTime now);
    bool drain();
    bool drainSome();
    Spooled readSpool();
    bool isApplied(const SpoolMark &mark) const;
    void noteSpool(bool isGood);
    bool writeChunks(bool isEverything);
    void noteRollups();
    bool writeReadings(int number, const OpenChunks::Sensor &sensor);
    bool writeSamples(int number, const OpenChunks::Sensor &sensor);
    bool fail();
    void noteDropped(const ArchiveInbox::Contents &contents);

    const ArchiveConfig m_config;
    const Note m_note;
    ArchiveStore m_store;
    std::unique_ptr<QLockFile> m_lock; ///< of the file or the spool; empty: not open
    std::unique_ptr<SpoolFile> m_spool; ///< only PostgreSQL
    SpoolMark m_applied; ///< the last one that the server has
    bool m_isSpoolFailing = false;
    RollupBook m_rollups{m_store};
    GapBook m_gaps{m_store};
    BackfillBook m_backfills{m_store, m_rollups};
    GapLedger m_ledger;
    OpenChunks m_open;
    ArchiveBatch m_waiting; ///< goes in with the next commit
    QHash<int, SensorRules> m_rules; ///< by N
    QHash<int, KnownSensor> m_known;
    qint64 m_lastRow = 0; ///< of the tail
    qint64 m_backfilled = 0; ///< what was committed
    std::unique_ptr<Salvage> m_salvage; ///< while there is something to take over
    bool m_hasStarted = false;
    bool m_isWaiting = false;
    bool m_isAnew = false; ///< the store is another one: what is open is not in its tail
    std::optional<UtcTime> m_triedAt; ///< the commit of which the outcome is not known
    ArchiveFault m_fault = ArchiveFault::None;
    QString m_error;
};

} // namespace gorizont
