#pragma once

#include "core/export/exportrequest.h"
#include "core/values/archivesource.h"

namespace gorizont::test {

/// What a small site kept, answered from memory: a ArchiveSource for tests.
struct KeptSite
{
    QList<Series> series; ///< whole curves; the answer holds what lies in the range
    QList<SampleBlock> blocks;
    QList<SeriesQuery> *asked = nullptr; ///< takes every query for series

    ArchiveSource source() const;
};

SensorConfig accelerometer(int number, const QString &place); ///< AN-D3: tilt, temperature, acceleration
SensorConfig inclinometer(int number, const QString &place); ///< IN-D3: tilt

SeriesBucket reading(UtcTime time, double value);
SeriesBucket noReading(UtcTime time); ///< an answer without a valid value

UtcTime utc(const char *iso); ///< `2018-02-07T15:33:03.250Z`

QByteArray contentOf(const QString &path); ///< fails the program if there is no such file

} // namespace gorizont::test
