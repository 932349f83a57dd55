#pragma once

#include "core/archive/keptreading.h"
#include "core/values/devicerecord.h"
#include "core/values/sampleblock.h"

namespace gorizont {

/// What a sensor measured long ago and what comes to the archive only now: out of its own memory, or out of old files.
struct Backfill
{
    int number = 0; ///< N
    QString source; ///< what the gaps say that they were filled from; ≤ 64 characters
    std::chrono::microseconds period{0}; ///< from one measurement to the next; 0: the median distance of what is there
    QList<DeviceRecord> records;
    QList<KeptReading> readings; ///< what is not valid in any quantity says nothing
    QList<SampleBlock> blocks;
    bool operator==(const Backfill &) const = default;
};

} // namespace gorizont
