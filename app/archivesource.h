#pragma once

#include "core/export/historysource.h"

namespace gorizont {

class ArchiveReader;

/// What pages and exports ask, answered by \a archive, which outlives the source.
HistorySource archiveSource(ArchiveReader &archive);

} // namespace gorizont
