#pragma once

#include "core/archive/archivebytes.h"

namespace gorizont {

/// What a row of the archive holds. The numbers stand in archives.
enum class ChunkKind : quint8 {
    FullRate = 1, ///< readings of a sensor
    Samples = 2, ///< raw ones of an accelerometer
    Minutes = 3, ///< rollups of one curve
    Hours = 4,
    Days = 5,
};

constexpr quint8 chunkVersion = 1;

/// Takes version, kind and count. Not good afterwards unless they are \a kind, of the version that is known.
inline quint64 takeChunkHead(ArchiveCursor &cursor, ChunkKind kind)
{
    if (cursor.byte() != chunkVersion || cursor.byte() != static_cast<quint8>(kind)) {
        cursor.fail();
    }
    return cursor.number();
}

} // namespace gorizont
