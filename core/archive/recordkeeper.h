#pragma once

#include "core/archive/archivestore.h"

#include <QMutex>

namespace gorizont {

/// Takes what was downloaded from devices into the store: every record once, and the gaps that they fill are marked with
/// their source. What cannot be written waits, up to a limit; it can be downloaded again. put() is for any thread, the rest
/// for that of the archive.
class RecordKeeper
{
public:
    static constexpr qsizetype mostRecords = 100'000;

    void put(const DeviceRecords &records);
    /// In a transaction of its own. False: nothing of it was written, it waits.
    bool write(ArchiveStore &store);
    qsizetype waiting() const; ///< records

private:
    QList<DeviceRecords> take();
    void putBack(const QList<DeviceRecords> &taken);

    mutable QMutex m_mutex; ///< guards m_waiting
    QList<DeviceRecords> m_waiting;
};

} // namespace gorizont
