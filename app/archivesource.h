#pragma once

#include "core/values/archivesource.h"

namespace gorizont {

class ArchiveReader;

/// What pages and exports ask, answered by \a archive, which outlives the source.
ArchiveSource archiveSource(ArchiveReader &archive);

} // namespace gorizont
