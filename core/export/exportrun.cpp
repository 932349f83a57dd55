#include "core/export/exportrun.h"

#include "core/export/exportsentences.h"
#include "core/export/seedexport.h"
#include "core/export/tableexport.h"

namespace gorizont {

namespace {

/// What is wrong with a request before anything is asked; empty: nothing.
QString problemOf(const ExportRequest &request, const ArchiveSource &source)
{
    if (request.from >= request.to) {
        return exportsentence::emptyRange();
    }
    if (request.format != ExportFormat::MiniSeed) {
        return exportedSeries(request).isEmpty() ? exportsentence::nothingChosen()
            : source.series                      ? QString()
                                                 : exportsentence::sourceGone();
    }
    const QList<SensorConfig> sensors = exportedAccelerometers(request);
    for (const SensorConfig &sensor : sensors) {
        if (seedLocation(sensor.number).isEmpty()) {
            return exportsentence::noLocation(sensor.number);
        }
    }
    if (sensors.isEmpty()) {
        return exportsentence::noAccelerometer();
    }
    if (!isValid(request.seed)) {
        return exportsentence::wrongCodes();
    }
    return source.blocks ? QString() : exportsentence::sourceGone();
}

} // namespace

ExportResult runExport(const ExportRequest &request, const ArchiveSource &source, ExportWatch &watch)
{
    if (const QString problem = problemOf(request, source); !problem.isEmpty()) {
        ExportResult result;
        result.failure = problem;
        return result;
    }
    if (request.format == ExportFormat::MiniSeed) {
        return SeedExport(request, source, watch).run();
    }
    return TableExport(request, source, watch).run();
}

} // namespace gorizont
