#pragma once

#include "core/export/exportrequest.h"

namespace gorizont {

/// From when on the samples of an accelerometer have a scale.
struct SeedScale
{
    int number = 0; ///< N, the sensor
    UtcTime from;
    double rate = 10; ///< samples a second
    double scale = 1; ///< mm/s² of one raw unit
};

/// What miniSEED has no place for: which sensor stands behind a channel, and what its numbers mean. A text to lie beside
/// the file, UTF-8, LF. Pure.
QByteArray seedNotes(const ExportRequest &request, const QList<SeedScale> &scales);

} // namespace gorizont
