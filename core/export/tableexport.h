#pragma once

#include "core/export/exportjob.h"
#include "core/export/seriesrows.h"

namespace gorizont {

/// The export of a table of values. In the thread of runExport().
class TableExport : public ExportJob
{
public:
    using ExportJob::ExportJob;

protected:
    bool writeAll() override;

private:
    UtcTime pieceEnd(UtcTime from) const;
    std::optional<QList<SeriesRow>> rowsBetween(UtcTime from, UtcTime to);
};

} // namespace gorizont
