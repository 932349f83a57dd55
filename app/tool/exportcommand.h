#pragma once

#include "app/tool/command.h"
#include "core/export/exportrequest.h"
#include "core/values/archivesource.h"

namespace gorizont::tool {

/// Exports, with progress on a terminal; Ctrl+C ends it and leaves no file. Prints the files and the number of rows.
/// ExitNoAnswer: the archive or the disk failed, or there is nothing in the range.
ExitCode exportHistory(const ExportRequest &request, const ArchiveSource &source, bool isJson);

} // namespace gorizont::tool
