#pragma once

#include "core/export/exportrequest.h"
#include "core/values/archivesource.h"

#include <atomic>

namespace gorizont {

/// What others do with an export that runs: look at it, and end it.
struct ExportWatch
{
    std::atomic_bool isCancelled{false}; ///< may be set from any thread and from a signal handler
    std::function<void(int percent, quint64 rows)> progress; ///< called in the thread of the export; may be empty
};

/// Writes what \a request asks for, piece by piece, so that a year needs no more memory than an hour. Blocks: not for a
/// thread that must not wait. Nothing that stood at the path is touched before all is written.
ExportResult runExport(const ExportRequest &request, const ArchiveSource &source, ExportWatch &watch);

} // namespace gorizont
