#pragma once

#include <QtGlobal>

namespace gorizont::test {

enum class DiskCall : quint8 { Write, Sync, Open, Truncate, Rename, Read };

/// From here on the \a nth call of that kind (1…) for a file of an archive or its spool fails, once, as if the disk were full or
/// broken; 0: none. Ends with the object. It stands in for the C library in the program that lists failingdisk.cpp among
/// its sources, where nothing is ever synced: that would only take time.
class FailingDisk
{
public:
    FailingDisk(DiskCall call, int nth);
    ~FailingDisk();
    Q_DISABLE_COPY_MOVE(FailingDisk)

    bool hasFailed() const; ///< it came to that
};

/// Writes that would make a file of an archive longer fail from now on, until it is called with false.
void fillDisk(bool isFull);

} // namespace gorizont::test
