#pragma once

#include "core/archive/archiveconfig.h"

#include <QStringList>

namespace gorizont {

/// The statements that bring tables of version n to version n + 1, for each n from 0 on. What was published is never
/// changed here, only continued.
///
///     meta    `schema`, the version; `alive`, when the last commit was (µs UTC); `salvage…`, SalvageMark
///     sensor  N, from when and until when there are valid values; the last rows of tail that are in chunks
///     chunk   readings at full rate and raw samples: kind, N, first and last time, data (ChunkKind)
///     rollup  of one curve and one stretch: kind, N, quantity, start of the stretch, data
///     tail    what is in no chunk yet, one row a commit (TailBatch)
///     gap     N, from, to (null: goes on), reason, source (not empty: filled)
///     event   the journal
///     record  what devices kept themselves: N, device's time, name, data; once each
const QList<QStringList> &archiveMigrations(ArchiveDriver driver);

} // namespace gorizont
