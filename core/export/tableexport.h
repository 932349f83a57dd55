#pragma once

#include "core/export/csvtable.h"
#include "core/export/exportjob.h"

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
    std::optional<QList<Series>> seriesBetween(UtcTime from, UtcTime to);
    bool writeRows(const CsvTable &table, const QList<Series> &series, UtcTime from, UtcTime to);
};

} // namespace gorizont
