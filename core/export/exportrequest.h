#pragma once

#include "core/export/seedcodes.h"
#include "core/values/quantity.h"
#include "core/values/series.h"

#include <QTimeZone>

namespace gorizont {

enum class ExportFormat : quint8 {
    CsvRussian, ///< `;`, decimal comma, local time: what a double click opens in a Russian Excel
    CsvIso, ///< `,`, decimal point, ISO 8601 in UTC: for programs
    MiniSeed, ///< the samples of accelerometers
};

/// One row for each …
enum class ExportEvery : quint8 { Reading, Minute, Hour, Day };

/// What somebody wants in a file.
struct ExportRequest
{
    ExportFormat format = ExportFormat::CsvRussian;
    QList<SensorConfig> sensors; ///< in the order of the columns
    QList<Quantity> quantities; ///< in the order of the columns; MiniSeed does not look at them
    UtcTime from;
    UtcTime to; ///< from ≤ t < to
    ExportEvery every = ExportEvery::Reading; ///< MiniSeed: always every sample
    QTimeZone zone; ///< of the clock on the wall; invalid: that of the computer
    SeedCodes seed;
    QString path; ///< of the file; one that exists is replaced
};

/// The columns of a table: of every sensor the quantities that it measures.
QList<SeriesKey> exportedSeries(const ExportRequest &request);

/// The sensors of a request that have samples.
QList<SensorConfig> exportedAccelerometers(const ExportRequest &request);

/// What an export came to.
struct ExportResult
{
    quint64 rows = 0; ///< of a table; samples of an axis in miniSEED
    QStringList files; ///< those that are written now; none: failed, cancelled, or nothing to write
    QString failure; ///< one sentence that says what to do; empty: done, or cancelled
    bool isCancelled = false;
};

} // namespace gorizont
